#include "player/render/picture_texture.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace vitrine {

namespace {

struct PlaneForm {
    GLenum storage = 0;
    GLenum format = 0;
    int bytes = 0;    // a texel
    int divisor = 1;  // of the picture's width and height, rounded up
};

constexpr PlaneForm rgba{GL_RGBA8, GL_RGBA, 4};
constexpr PlaneForm brightness{GL_R8, GL_RED, 1};
constexpr PlaneForm one_difference{GL_R8, GL_RED, 1, 2};
constexpr PlaneForm both_differences{GL_RG8, GL_RG, 2, 2};

std::size_t plane_count(PixelLayout layout) {
    switch (layout) {
    case PixelLayout::rgba:
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

}  // namespace

PictureTexture::PictureTexture(const Sample& sample)
    : width_(sample.width), height_(sample.height), layout_(sample.layout) {
    assert(width_ > 0 && height_ > 0);
    for (std::size_t i = 0; i < plane_count(layout_); ++i) {
        const PlaneForm plane = form(layout_, i);
        const int width = share(width_, plane);
        const int height = share(height_, plane);
        const auto levels =
            static_cast<GLsizei>(std::bit_width(static_cast<unsigned>(std::max(width, height))));
        glBindTexture(GL_TEXTURE_2D, planes_[i].id());
        glTexStorage2D(GL_TEXTURE_2D, levels, plane.storage, width, height);
    }
    check_gl("make room for a picture");
}

bool PictureTexture::fits(const Sample& sample) const {
    return width_ == sample.width && height_ == sample.height && layout_ == sample.layout;
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
    has_smaller_copies_ = false;
    ++uploads_;
}

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

void PictureTexture::make_smaller_copies() {
    if (has_smaller_copies_) return;
    for (std::size_t i = 0; i < plane_count(layout_); ++i) {
        glBindTexture(GL_TEXTURE_2D, planes_[i].id());
        glGenerateMipmap(GL_TEXTURE_2D);
    }
    has_smaller_copies_ = true;
}

}  // namespace vitrine
