#pragma once

#include "player/playback/sample.hpp"
#include "player/render/gl_objects.hpp"
#include "player/render/picture_texture.hpp"
#include "player/scene/frame.hpp"

#include <array>
#include <optional>
#include <string>

namespace vitrine::player {

/// An item's picture for one drawing.
struct DrawnPicture {
    const PictureTexture& texture;  // the picture, or a reduced copy of it
    Vec2 slide;                     // the share of Sample::slide that is drawn
    bool is_exact = false;          // each texel is drawn as one pixel
};

/// Texels of a picture per canvas px, across.
inline double texels_a_px(const PictureTexture& picture, const DrawItem& item) {
    return picture.width() / (item.picture.x * item.placement.scale);
}

/// A GL program that draws the picture of an item into its cell.
class PictureProgram {
  public:
    explicit PictureProgram(const std::string& fragment_shader);

    /// Takes the program into use and sets all uniforms for an item.
    void use(const DrawItem& item, const DrawnPicture& picture, const ToNdc& view) const;

    /// True if it fills a cell with the blurred picture.
    bool is_filler() const { return blur_ >= 0; }

  private:
    void set_texels(const DrawItem& item, const DrawnPicture& picture) const;
    void set_blur(const DrawItem& item, const PictureTexture& texture) const;

    GlProgram program_;
    ViewUniforms view_;
    GLint uv_scale_;
    GLint uv_offset_;
    GLint blur_;     // -1: the program draws sharp
    GLint level_;    // -1: the program draws sharp
    GLint mirrors_;  // -1: the program draws sharp
    GLint light_;    // -1: the program draws sharp
    GLint alpha_;    // -1: the program draws opaque
    GLint to_rgb_;   // -1: the picture is in RGB
    GLint zero_;     // -1: the picture is in RGB
};

/// The programs for one layout of pixels.
struct PicturePrograms {
    explicit PicturePrograms(PixelLayout layout);

    PictureProgram opaque;
    PictureProgram blended;
    PictureProgram filler;
};

}  // namespace vitrine::player
