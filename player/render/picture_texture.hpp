#pragma once

#include "player/playback/sample.hpp"
#include "player/render/gl_objects.hpp"

#include <array>
#include <cstdint>

namespace vitrine {

/// A picture on the graphics card: one texture, or one a plane, which the shaders for planes put together.
class PictureTexture {
  public:
    /// @throws std::runtime_error when the graphics card has no room
    explicit PictureTexture(const Sample& sample);

    /// Whether a picture can be put into this without making room anew.
    bool fits(const Sample& sample) const;

    /// The pixels are copied before this returns. @pre fits(sample)
    void upload(const Sample& sample);

    /// To the texture units 0 and on, with the same filter and wrap for all planes.
    void bind(GLint smaller, GLint larger, GLint wrap) const;

    /// Smaller copies of what was uploaded last; nothing to do where there are some.
    void make_smaller_copies();

    int width() const { return width_; }

    int height() const { return height_; }

    PixelLayout layout() const { return layout_; }

    const ColourCode& colours() const { return colours_; }

    bool has_smaller_copies() const { return has_smaller_copies_; }

    /// False: it was uploaded more than once, as films are.
    bool is_still() const { return uploads_ == 1; }

  private:
    int width_;  // px
    int height_;
    PixelLayout layout_;
    ColourCode colours_;
    std::array<GlTexture, 3> planes_;  // as many as the layout has, the rest unused
    bool has_smaller_copies_ = false;
    std::uint64_t uploads_ = 0;
};

}  // namespace vitrine
