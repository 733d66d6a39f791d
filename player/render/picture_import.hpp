#pragma once

#include "player/playback/sample.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES2/gl2.h>
#include <GLES2/gl2ext.h>

#include <cstdint>
#include <vector>

namespace vitrine::player {

/// One plane of a picture.
struct PlaneShape {
    std::size_t index = 0;  // index among the picture's planes
    int channels = 1;       // 1 or 2, of 8 bits
    int width = 0;          // texels
    int height = 0;
};

/// Reads shared planes into textures without copying them (EGL_EXT_image_dma_buf_import), one texture for
/// each plane, so that they are drawn like uploaded ones. Uses the display that is current when this is made.
class PictureImport {
  public:
    PictureImport();

    /// True if the display can do so and accepts planes of one and of two channels.
    bool is_possible() const { return into_texture_ != nullptr && takes_planes_; }

    /// Makes the texture bound to GL_TEXTURE_2D read a plane.
    /// @throws std::runtime_error with EGL's reason: the display does not accept the plane
    void read(const SharedPlanes& shared, const PlaneShape& plane) const;

  private:
    EGLDisplay display_;
    bool takes_planes_ = false;
    bool knows_modifiers_ = false;
    PFNGLEGLIMAGETARGETTEXTURE2DOESPROC into_texture_ = nullptr;
};

/// The attributes that describe a plane for EGL.
/// @param names_modifier  true: the display has EGL_EXT_image_dma_buf_import_modifiers
/// @throws std::runtime_error if a modifier must be named and cannot be
std::vector<EGLAttrib> import_attributes(const SharedPlanes& shared, const PlaneShape& plane,
                                         bool names_modifier);

}  // namespace vitrine::player
