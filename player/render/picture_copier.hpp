#pragma once

#include "player/render/gl_objects.hpp"

namespace vitrine::player {

/// Copies pictures from one texture to another, or from one smaller copy of a texture to the next. While this
/// lives, GL draws to a frame buffer of its own and cuts nothing off.
class PictureCopier {
  public:
    /// A texture, or one of its smaller copies.
    struct Copy {
        GLuint texture = 0;
        int level = 0;
        int width = 0;  // texels
        int height = 0;
    };

    PictureCopier();
    PictureCopier(const PictureCopier&) = delete;
    PictureCopier& operator=(const PictureCopier&) = delete;
    PictureCopier(PictureCopier&&) = delete;
    PictureCopier& operator=(PictureCopier&&) = delete;
    ~PictureCopier();

    /// Scales linearly: each texel is read at its middle from the four that lie nearest.
    void copy(const Copy& from, const Copy& to) const;

  private:
    using FrameBuffer = GlObject<&glGenFramebuffers, &glDeleteFramebuffers>;

    bool is_cut_;         // before this
    GLint drawn_to_ = 0;  // before this
    FrameBuffer from_;
    FrameBuffer to_;
};

}  // namespace vitrine::player
