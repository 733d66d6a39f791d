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
    std::size_t index = 0;  // among the picture's planes
    int channels = 1;       // 1 or 2, of 8 bits
    int width = 0;          // texels
    int height = 0;
};

/// Reads shared planes into textures without copying them (EGL_EXT_image_dma_buf_import), one texture a
/// plane, so that they are drawn as uploaded ones are. Of the display that is current where it is made.
class PictureImport {
  public:
    PictureImport();

    /// True if the display can do so, and says that it takes planes of one and of two channels.
    bool is_possible() const { return into_texture_ != nullptr && takes_planes_; }

    /// Makes the texture that is bound to GL_TEXTURE_2D read a plane.
    /// @throws std::runtime_error with EGL's reason: the display does not take it
    void read(const SharedPlanes& shared, const PlaneShape& plane) const;

  private:
    EGLDisplay display_;
    bool takes_planes_ = false;
    bool knows_modifiers_ = false;
    PFNGLEGLIMAGETARGETTEXTURE2DOESPROC into_texture_ = nullptr;
};

/// The attributes that describe a plane to EGL.
/// @param names_modifier  whether the display has EGL_EXT_image_dma_buf_import_modifiers
/// @throws std::runtime_error where a modifier has to be named and cannot be
std::vector<EGLAttrib> import_attributes(const SharedPlanes& shared, const PlaneShape& plane,
                                         bool names_modifier);

}  // namespace vitrine::player
