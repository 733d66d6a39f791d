#pragma once

#include "player/playback/sample.hpp"
#include "player/render/gl_objects.hpp"
#include "player/render/picture_import.hpp"

#include <array>
#include <cstdint>
#include <memory>

namespace vitrine::player {

/// The way in which texels become pixels.
enum class Sampling {
    smooth,  // filtered
    exact,   // a texel is a pixel
    filler,  // from smaller copies, mirrored beyond the edges
};

/// A picture on the graphics card: one texture, or one a plane, which the shaders for planes put together.
class PictureTexture {
  public:
    /// @throws std::runtime_error when the graphics card has no room
    explicit PictureTexture(const Sample& sample);

    /// A picture of shared planes, which stay where they are.
    /// @throws std::runtime_error where they cannot be read there
    PictureTexture(const Sample& sample, const PictureImport& import);

    /// True if a picture can be put into this without making room anew; never into shared planes.
    bool fits(const Sample& sample) const;

    /// The pixels are copied before this returns. @pre fits(sample)
    void upload(const Sample& sample);

    /// Binds the planes to the texture units 0 and on. Smaller copies are made of a photo that is shown
    /// small, once; a film is not worth them, as it would need them for every picture. Filler does need them,
    /// of both. @pre for filler: the picture is not of shared planes
    /// @param texels  texels of the picture a canvas px
    void bind_sampled(Sampling sampling, double texels);

    /// The picture that has or can have smaller copies: this, or for shared planes one a quarter as wide.
    PictureTexture& reduced();

    /// The holder of shared planes, which must live until the graphics card has read them.
    const std::shared_ptr<const void>& lender() const { return lender_; }

    int width() const { return width_; }

    int height() const { return height_; }

    PixelLayout layout() const { return layout_; }

    const ColourCode& colours() const { return colours_; }

  private:
    PictureTexture(int width, int height, PixelLayout layout, const ColourCode& colours);

    /// False: it was uploaded more than once, or is shared, as films are.
    bool is_still() const { return uploads_ == 1 && !lender_; }

    void make_room();
    void bind(GLint smaller, GLint larger, GLint wrap) const;
    void make_smaller_copies();
    void copy_from(const PictureTexture& larger);

    int width_;  // px
    int height_;
    PixelLayout layout_;
    ColourCode colours_;
    std::array<GlTexture, 3> planes_;     // the first ones, by the layout, are used
    std::shared_ptr<const void> lender_;  // shared: the decoder's buffer pool; none: the planes are our own
    std::unique_ptr<PictureTexture> reduced_;
    bool has_smaller_copies_ = false;
    std::uint64_t uploads_ = 0;
};

}  // namespace vitrine::player
