#include "player/render/picture_texture.hpp"

#include "player/render/picture_copier.hpp"

#include <GLES2/gl2ext.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace vitrine::player {

namespace {

struct PlaneForm {
    GLenum storage = 0;  // 0: the same as `format` (GL_EXT_texture_format_BGRA8888)
    GLenum format = 0;
    int bytes = 0;    // a texel
    int divisor = 1;  // the plane has the picture's width and height divided by this, rounded up
};

constexpr double small_picture = 1.5;  // texels a canvas px; above this, single texels would be skipped
constexpr double blur = 0.25;          // radius of the filler's blur, as a share of the shorter side
constexpr int reduction = 4;           // factor by which shared planes are reduced for the filler's blur

constexpr PlaneForm rgba{GL_RGBA8, GL_RGBA, 4};
constexpr PlaneForm bgra{0, GL_BGRA_EXT, 4};
constexpr PlaneForm brightness{GL_R8, GL_RED, 1};
constexpr PlaneForm one_difference{GL_R8, GL_RED, 1, 2};
constexpr PlaneForm both_differences{GL_RG8, GL_RG, 2, 2};

std::size_t plane_count(PixelLayout layout) {
    switch (layout) {
    case PixelLayout::rgba:
    case PixelLayout::bgra:
        return 1;
    case PixelLayout::nv12:
        return 2;
    case PixelLayout::i420:
        break;
    }
    return 3;
}

PlaneForm form(PixelLayout layout, std::size_t plane) {
    if (layout == PixelLayout::rgba) return rgba;
    if (layout == PixelLayout::bgra) return bgra;
    if (plane == 0) return brightness;
    return layout == PixelLayout::nv12 ? both_differences : one_difference;
}

int share(int length, const PlaneForm& form) {
    return (length + form.divisor - 1) / form.divisor;
}

Sample::Plane plane_of(const Sample& sample, std::size_t index) {
    return index == 0 ? Sample::Plane{sample.stride, sample.pixels} : sample.chroma[index - 1];
}

void upload_plane(const Sample::Plane& plane, const PlaneForm& form, int width, int height) {
    const auto bytes = static_cast<std::size_t>(form.bytes);
    assert(plane.stride % bytes == 0);
    assert(plane.bytes.size() >=
           plane.stride * static_cast<std::size_t>(height - 1) + static_cast<std::size_t>(width) * bytes);
    glPixelStorei(GL_UNPACK_ALIGNMENT, form.bytes);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(plane.stride / bytes));
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, form.format, GL_UNSIGNED_BYTE, plane.bytes.data());
}

/// The number of a picture's copies down to one texel, with the picture itself.
int level_count(int width, int height) {
    return std::bit_width(static_cast<unsigned>(std::max(width, height)));
}

/// The width or the height of a smaller copy.
int length_at(int level, int length) {
    return std::max(1, length >> level);
}

/// Reserves memory for the bound texture and its smaller copies.
void reserve(const PlaneForm& form, int width, int height) {
    const int levels = level_count(width, height);
    if (form.storage != 0) {
        glTexStorage2D(GL_TEXTURE_2D, levels, form.storage, width, height);
        return;
    }
    for (int level = 0; level < levels; ++level)
        glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(form.format), length_at(level, width),
                     length_at(level, height), 0, form.format, GL_UNSIGNED_BYTE, nullptr);
}

}  // namespace

PictureTexture::PictureTexture(int width, int height, PixelLayout layout, const ColourCode& colours)
    : width_(width), height_(height), layout_(layout), colours_(colours) {
    assert(width_ > 0 && height_ > 0);
    for (std::size_t i = 0; i < plane_count(layout_); ++i) {
        const PlaneForm plane = form(layout_, i);
        glBindTexture(GL_TEXTURE_2D, planes_[i].id());
        reserve(plane, share(width_, plane), share(height_, plane));
    }
    check_gl("make room for a picture");
}

PictureTexture::PictureTexture(const Sample& sample)
    : PictureTexture(sample.width, sample.height, sample.layout, sample.colours) {}

PictureTexture::PictureTexture(const Sample& sample, const PictureImport& import)
    : width_(sample.width),
      height_(sample.height),
      layout_(sample.layout),
      colours_(sample.colours),
      lender_(sample.owner),
      uploads_(1) {
    assert(sample.shared && !is_rgb(layout_));
    for (std::size_t i = 0; i < plane_count(layout_); ++i) {
        const PlaneForm plane = form(layout_, i);
        glBindTexture(GL_TEXTURE_2D, planes_[i].id());
        import.read(*sample.shared, {.index = i,
                                     .channels = plane.bytes,
                                     .width = share(width_, plane),
                                     .height = share(height_, plane)});
    }
}

bool PictureTexture::fits(const Sample& sample) const {
    return !lender_ && width_ == sample.width && height_ == sample.height && layout_ == sample.layout;
}

void PictureTexture::upload(const Sample& sample) {
    assert(fits(sample));
    for (std::size_t i = 0; i < plane_count(layout_); ++i) {
        const PlaneForm plane = form(layout_, i);
        glBindTexture(GL_TEXTURE_2D, planes_[i].id());
        upload_plane(plane_of(sample, i), plane, share(width_, plane), share(height_, plane));
    }
    check_gl("upload a picture");
    colours_ = sample.colours;
    smaller_copies_ = 0;
    ++uploads_;
}

void PictureTexture::prepare(double texels) {
    if (texels >= small_picture && is_still()) make_smaller_copies(level_count(width_, height_) - 1);
}

void PictureTexture::prepare_filler() {
    make_smaller_copies(blur_level());
}

double PictureTexture::blur_radius() const {
    return blur * std::min(width_, height_);
}

int PictureTexture::blur_level() const {
    return std::max(0, static_cast<int>(std::lround(std::log2(blur_radius()))) - 1);
}

void PictureTexture::bind_sampled(Sampling sampling) const {
    const GLint wrap = sampling == Sampling::filler ? GL_MIRRORED_REPEAT : GL_CLAMP_TO_EDGE;
    if (sampling == Sampling::exact) return bind(GL_NEAREST, GL_NEAREST, wrap);
    bind(smaller_copies_ > 0 ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR, GL_LINEAR, wrap);
}

/// Binds the planes to the texture units from 0 on, all with the same filter and wrap.
void PictureTexture::bind(GLint smaller, GLint larger, GLint wrap) const {
    for (std::size_t i = plane_count(layout_); i-- > 0;) {
        glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + i));
        glBindTexture(GL_TEXTURE_2D, planes_[i].id());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, smaller);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, larger);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    }
}

PictureTexture& PictureTexture::reduced() {
    if (!lender_) return *this;
    if (reduced_) return *reduced_;
    const auto part = [](int length) { return std::max(1, length / reduction); };
    reduced_.reset(
        new PictureTexture(part(width_), part(height_), layout_, colours_));  // the constructor is private
    reduced_->copy_from(*this);
    return *reduced_;
}

// Half of the texels in each direction are skipped. This does no harm: the copy is only used blurred.
void PictureTexture::copy_from(const PictureTexture& larger) {
    const PictureCopier copier;
    for (std::size_t i = 0; i < plane_count(layout_); ++i) {
        const PlaneForm plane = form(layout_, i);
        copier.copy(
            {.texture = larger.planes_[i].id(),
             .width = share(larger.width_, plane),
             .height = share(larger.height_, plane)},
            {.texture = planes_[i].id(), .width = share(width_, plane), .height = share(height_, plane)});
    }
    check_gl("make a smaller copy of a decoder's picture");
}

// glGenerateMipmap leaves the way to the driver. With NVIDIA's, a fifth of random frames had blocks that were
// 3 to 8 steps too bright or too dark. It would make all copies, too.
void PictureTexture::make_smaller_copies(int last) {
    assert(!lender_);
    if (smaller_copies_ >= last) return;
    const PictureCopier copier;
    for (std::size_t i = 0; i < plane_count(layout_); ++i) {
        const PlaneForm plane = form(layout_, i);
        const int width = share(width_, plane);
        const int height = share(height_, plane);
        const auto copy_at = [&](int level) {
            return PictureCopier::Copy{.texture = planes_[i].id(),
                                       .level = level,
                                       .width = length_at(level, width),
                                       .height = length_at(level, height)};
        };
        const int end = std::min(last, level_count(width, height) - 1);
        for (int level = smaller_copies_; level < end; ++level)
            copier.copy(copy_at(level), copy_at(level + 1));
        glBindTexture(GL_TEXTURE_2D, planes_[i].id());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, end);
    }
    smaller_copies_ = last;
    check_gl("make smaller copies of a picture");
}

}  // namespace vitrine::player
