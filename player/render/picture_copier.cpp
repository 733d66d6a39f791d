#include "player/render/picture_copier.hpp"

namespace vitrine::player {

PictureCopier::PictureCopier() : is_cut_(glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE) {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn_to_);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to_.id());
}

PictureCopier::~PictureCopier() {
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(drawn_to_));
    if (is_cut_) glEnable(GL_SCISSOR_TEST);
}

void PictureCopier::copy(const Copy& from, const Copy& to) const {
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, from.texture,
                           from.level);
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, to.texture, to.level);
    glBlitFramebuffer(0, 0, from.width, from.height, 0, 0, to.width, to.height, GL_COLOR_BUFFER_BIT,
                      GL_LINEAR);
}

}  // namespace vitrine::player
