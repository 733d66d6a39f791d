#pragma once

#include "player/playback/sample.hpp"
#include "player/render/gl_objects.hpp"
#include "player/render/picture_import.hpp"

#include <array>
#include <cstdint>
#include <memory>

namespace vitrine::player {

/// The sampling of texels.
enum class Sampling {
    smooth,  // filtered
    exact,   // each texel is one pixel
    filler,  // from smaller copies, mirrored at the edges
};

/// A picture on the graphics card: one texture, or one for each plane, which the shaders for planes combine.
class PictureTexture {
  public:
    /// @throws std::runtime_error if the graphics card has no room
    explicit PictureTexture(const Sample& sample);

    /// A picture of shared planes, which are not copied.
    /// @throws std::runtime_error if they cannot be read in place
    PictureTexture(const Sample& sample, const PictureImport& import);

    /// True if a picture fits into this without new memory; never for shared planes.
    bool fits(const Sample& sample) const;

    /// The pixels are copied before this returns. @pre fits(sample)
    void upload(const Sample& sample);

    /// Makes the smaller copies that drawing needs, once for a photo that is shown small. A film gets none,
    /// because it would need them for every picture. Call it before the frame is drawn: the copies are drawn
    /// to frame buffers of their own.
    /// @param texels  texels of the picture per canvas px
    void prepare(double texels);

    /// Makes the smaller copies that the filler needs, before the frame is drawn.
    /// @pre the picture is not of shared planes
    void prepare_filler();

    /// Binds the planes to the texture units from 0 on. @pre it is prepared for this
    void bind_sampled(Sampling sampling) const;

    /// The picture that can have smaller copies: this one, or for shared planes a copy a quarter as wide.
    PictureTexture& reduced();

    /// The owner of shared planes. It must live until the graphics card has read them.
    const std::shared_ptr<const void>& lender() const { return lender_; }

    /// Radius of the filler's blur, texels.
    double blur_radius() const;

    /// The smaller copy that the filler reads, of which a texel is about half the blur's radius wide.
    int blur_level() const;

    int width() const { return width_; }

    int height() const { return height_; }

    PixelLayout layout() const { return layout_; }

    const ColourCode& colours() const { return colours_; }

  private:
    PictureTexture(int width, int height, PixelLayout layout, const ColourCode& colours);

    /// False: it is a film's, because it was uploaded more than once or is shared.
    bool is_still() const { return uploads_ == 1 && !lender_; }

    void bind(GLint smaller, GLint larger, GLint wrap) const;
    void make_smaller_copies(int last);
    void copy_from(const PictureTexture& larger);

    int width_;  // px
    int height_;
    PixelLayout layout_;
    ColourCode colours_;
    std::array<GlTexture, 3> planes_;     // the layout says how many of them are used
    std::shared_ptr<const void> lender_;  // shared by the decoder's buffer pool; none: the planes are our own
    std::unique_ptr<PictureTexture> reduced_;
    int smaller_copies_ = 0;  // how many have been made of this picture
    std::uint64_t uploads_ = 0;
};

}  // namespace vitrine::player
