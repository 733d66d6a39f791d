#include "player/display/memory_target.hpp"

#include <GLES2/gl2ext.h>
#include <fmt/format.h>

#include <stdexcept>

namespace vitrine::player {

MemoryTarget::Names::Names() {
    glGenFramebuffers(1, &frame_buffer);
    glGenTextures(1, &colours);
}

MemoryTarget::Names::~Names() {
    glDeleteTextures(1, &colours);
    glDeleteFramebuffers(1, &frame_buffer);
}

MemoryTarget::MemoryTarget(int width, int height) : width_(width), height_(height) {
    glBindTexture(GL_TEXTURE_2D, names_.colours);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_BGRA_EXT, width_, height_, 0, GL_BGRA_EXT, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, names_.frame_buffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, names_.colours, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error(fmt::format("no picture of {}x{} px in memory", width_, height_));
}

void MemoryTarget::make_current() const {
    glBindFramebuffer(GL_FRAMEBUFFER, names_.frame_buffer);
}

void MemoryTarget::read(const std::function<void(std::span<const std::byte> row)>& take) {
    const std::size_t row = static_cast<std::size_t>(width_) * 4;
    rows_.resize(row * static_cast<std::size_t>(height_));
    copy(rows_);
    for (std::size_t end = rows_.size(); end > 0; end -= row)
        take(std::span(rows_).subspan(end - row, row));
}

CardPicture MemoryTarget::picture() {
    CardPicture picture = pictures_.next(width_, height_);
    picture.is_bottom_first = true;
    copy({picture.pixels.get(), static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4});
    return picture;
}

// Blue first needs GL_EXT_read_format_bgra, which Mesa always has. Any other order costs Mesa ten times as
// much.
void MemoryTarget::copy(std::span<std::byte> rows) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, names_.frame_buffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glReadPixels(0, 0, width_, height_, GL_BGRA_EXT, GL_UNSIGNED_BYTE, rows.data());
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error(fmt::format("read the drawn picture: GL error {:#x}", error));
}

}  // namespace vitrine::player
