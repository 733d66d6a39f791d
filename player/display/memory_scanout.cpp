#include "player/display/memory_scanout.hpp"

#include "base/system/error.hpp"

#include <GLES3/gl3.h>
#include <drm_fourcc.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <xf86drmMode.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <stdexcept>

namespace vitrine {

namespace {

constexpr GLenum bgra = 0x80E1;  // of GL_EXT_read_format_bgra, which Mesa always has

}  // namespace

// A buffer that the card calls dumb: mapped for as long as it lives, so also after the card has gone.
class MemoryScanout::Buffer {
  public:
    Buffer(const Card& card, int width, int height) : card_(card.fd()) {
        try {
            make(card, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
        } catch (const std::runtime_error&) {
            end();
            throw;
        }
    }

    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    Buffer(Buffer&&) = delete;
    Buffer& operator=(Buffer&&) = delete;

    ~Buffer() { end(); }

    std::uint32_t frame_buffer() const { return frame_buffer_; }

    std::byte* row(int y) { return static_cast<std::byte*>(pixels_) + static_cast<std::size_t>(y) * pitch_; }

  private:
    void make(const Card& card, std::uint32_t width, std::uint32_t height) {
        constexpr std::uint32_t bits = 32;
        if (drmModeCreateDumbBuffer(card_, width, height, bits, 0, &handle_, &pitch_, &size_) != 0)
            throw_errno("make a buffer of {}x{} px on '{}'", width, height, card.path().string());
        const std::array<std::uint32_t, 4> handles{handle_};
        const std::array<std::uint32_t, 4> pitches{pitch_};
        const std::array<std::uint32_t, 4> offsets{};
        if (drmModeAddFB2(card_, width, height, DRM_FORMAT_XRGB8888, handles.data(), pitches.data(),
                          offsets.data(), &frame_buffer_, 0) != 0)
            throw_errno("'{}' takes no buffer of {}x{} px", card.path().string(), width, height);
        std::uint64_t offset = 0;
        if (drmModeMapDumbBuffer(card_, handle_, &offset) != 0)
            throw_errno("map a buffer of '{}'", card.path().string());
        pixels_ =
            ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, card_, static_cast<off_t>(offset));
        if (pixels_ == MAP_FAILED) throw_errno("map a buffer of '{}'", card.path().string());
        std::memset(pixels_, 0, size_);  // has all of it there before the first picture
    }

    void end() {
        if (pixels_ != MAP_FAILED) ::munmap(pixels_, size_);
        if (frame_buffer_ != 0) drmModeRmFB(card_, frame_buffer_);
        if (handle_ != 0) drmModeDestroyDumbBuffer(card_, handle_);
    }

    int card_;
    std::uint32_t handle_ = 0;
    std::uint32_t pitch_ = 0;  // bytes a row
    std::uint64_t size_ = 0;
    std::uint32_t frame_buffer_ = 0;
    void* pixels_ = MAP_FAILED;
};

MemoryScanout::MemoryScanout(const Card& card, int width, int height) : width_(width), height_(height) {
    for (auto& buffer : buffers_)
        buffer = std::make_shared<Buffer>(card, width, height);
    rows_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    glGenFramebuffers(1, &frame_buffer_);
    glGenRenderbuffers(1, &colour_);
    glBindRenderbuffer(GL_RENDERBUFFER, colour_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_buffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    glDeleteFramebuffers(1, &frame_buffer_);
    glDeleteRenderbuffers(1, &colour_);
    throw std::runtime_error(fmt::format("no picture of {}x{} px in memory", width, height));
}

MemoryScanout::~MemoryScanout() {
    glDeleteFramebuffers(1, &frame_buffer_);
    glDeleteRenderbuffers(1, &colour_);
}

void MemoryScanout::make_current() {
    glBindFramebuffer(GL_FRAMEBUFFER, frame_buffer_);
}

bool MemoryScanout::has_free_buffer() const {
    return std::ranges::any_of(buffers_, [](const auto& buffer) { return buffer.use_count() == 1; });
}

ScanoutBuffer MemoryScanout::take() {
    const auto free =
        std::ranges::find_if(buffers_, [](const auto& buffer) { return buffer.use_count() == 1; });
    assert(free != buffers_.end());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_buffer_);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glReadPixels(0, 0, width_, height_, bgra, GL_UNSIGNED_BYTE, rows_.data());
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error(fmt::format("read what was drawn: GL error {:#x}", error));
    const std::size_t row = static_cast<std::size_t>(width_) * 4;
    for (int y = 0; y < height_; ++y)
        std::memcpy((*free)->row(y), rows_.data() + static_cast<std::size_t>(height_ - 1 - y) * row, row);
    return {.frame_buffer = (*free)->frame_buffer(), .lease = *free};
}

}  // namespace vitrine
