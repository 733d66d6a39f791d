#include "player/render/picture_import.hpp"

#include "player/display/gl_device.hpp"
#include "player/render/gl_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace vitrine::player {

namespace {

// DRM's names of planes, drm_fourcc.h.
constexpr EGLint fourcc(char a, char b, char c, char d) {
    return a | b << 8 | c << 16 | d << 24;
}

constexpr EGLint one_channel = fourcc('R', '8', ' ', ' ');
constexpr EGLint two_channels = fourcc('G', 'R', '8', '8');
constexpr std::uint64_t row_by_row = 0;  // DRM_FORMAT_MOD_LINEAR

// A display that cannot list its formats may still accept this one.
bool takes(EGLDisplay display, EGLint format) {
    const auto ask =
        reinterpret_cast<PFNEGLQUERYDMABUFFORMATSEXTPROC>(eglGetProcAddress("eglQueryDmaBufFormatsEXT"));
    EGLint count = 0;
    if (!ask || !ask(display, 0, nullptr, &count)) return true;
    std::vector<EGLint> formats(static_cast<std::size_t>(count));
    if (!ask(display, count, formats.data(), &count)) return true;
    return std::ranges::find(formats, format) != formats.end();
}

}  // namespace

PictureImport::PictureImport() : display_(eglGetCurrentDisplay()) {
    const char* const words = display_ == EGL_NO_DISPLAY ? nullptr : eglQueryString(display_, EGL_EXTENSIONS);
    const char* const gl_words = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    if (!has_word(words, "EGL_EXT_image_dma_buf_import") || !has_word(gl_words, "GL_OES_EGL_image")) return;
    knows_modifiers_ = has_word(words, "EGL_EXT_image_dma_buf_import_modifiers");
    into_texture_ = reinterpret_cast<PFNGLEGLIMAGETARGETTEXTURE2DOESPROC>(
        eglGetProcAddress("glEGLImageTargetTexture2DOES"));
    takes_planes_ = !knows_modifiers_ || (takes(display_, one_channel) && takes(display_, two_channels));
}

void PictureImport::read(const SharedPlanes& shared, const PlaneShape& plane) const {
    const std::vector<EGLAttrib> attributes = import_attributes(shared, plane, knows_modifiers_);
    const EGLImage image =
        eglCreateImage(display_, EGL_NO_CONTEXT, EGL_LINUX_DMA_BUF_EXT, nullptr, attributes.data());
    if (image == EGL_NO_IMAGE)
        throw std::runtime_error(fmt::format("read a decoder's plane of {}x{}: EGL error {:#x}", plane.width,
                                             plane.height, eglGetError()));
    into_texture_(GL_TEXTURE_2D, image);
    eglDestroyImage(display_, image);  // the texture keeps it
    check_gl("read a decoder's plane");
}

std::vector<EGLAttrib> import_attributes(const SharedPlanes& shared, const PlaneShape& plane,
                                         bool names_modifier) {
    const SharedPlanes::Plane& place = shared.planes.at(plane.index);
    std::vector<EGLAttrib> list{EGL_WIDTH,
                                plane.width,
                                EGL_HEIGHT,
                                plane.height,
                                EGL_LINUX_DRM_FOURCC_EXT,
                                plane.channels == 1 ? one_channel : two_channels,
                                EGL_DMA_BUF_PLANE0_FD_EXT,
                                place.file,
                                EGL_DMA_BUF_PLANE0_OFFSET_EXT,
                                place.offset,
                                EGL_DMA_BUF_PLANE0_PITCH_EXT,
                                place.stride};
    const std::uint64_t modifier = shared.modifier.value_or(row_by_row);
    if (modifier != row_by_row && !names_modifier)
        throw std::runtime_error(
            fmt::format("a decoder's order of pixels, {:#x}, cannot be passed to EGL here", modifier));
    if (shared.modifier && names_modifier) {
        list.insert(list.end(),
                    {EGL_DMA_BUF_PLANE0_MODIFIER_LO_EXT, static_cast<EGLAttrib>(modifier & 0xFFFFFFFF),
                     EGL_DMA_BUF_PLANE0_MODIFIER_HI_EXT, static_cast<EGLAttrib>(modifier >> 32)});
    }
    list.push_back(EGL_NONE);
    return list;
}

}  // namespace vitrine::player
