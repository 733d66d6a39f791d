#include "player/display/memory_target.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace vitrine {

MemoryTarget::Names::Names() {
    glGenFramebuffers(1, &frame_buffer);
    glGenRenderbuffers(1, &colour);
}

MemoryTarget::Names::~Names() {
    glDeleteRenderbuffers(1, &colour);
    glDeleteFramebuffers(1, &frame_buffer);
}

MemoryTarget::MemoryTarget(int width, int height) : width_(width), height_(height) {
    glBindRenderbuffer(GL_RENDERBUFFER, names_.colour);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_, height_);
    glBindFramebuffer(GL_FRAMEBUFFER, names_.frame_buffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names_.colour);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error(fmt::format("no picture of {}x{} px in memory", width_, height_));
}

void MemoryTarget::make_current() const {
    glBindFramebuffer(GL_FRAMEBUFFER, names_.frame_buffer);
}

void MemoryTarget::read(GLenum format, const std::function<void(std::span<const std::byte> row)>& take) {
    const std::size_t row = static_cast<std::size_t>(width_) * 4;
    rows_.resize(row * static_cast<std::size_t>(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, names_.frame_buffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glReadPixels(0, 0, width_, height_, format, GL_UNSIGNED_BYTE, rows_.data());
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error(fmt::format("read what was drawn: GL error {:#x}", error));
    for (std::size_t end = rows_.size(); end > 0; end -= row)
        take(std::span(rows_).subspan(end - row, row));
}

}  // namespace vitrine
