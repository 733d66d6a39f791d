#include "player/display/memory_scanout.hpp"

#include "base/system/error.hpp"

#include <drm_fourcc.h>
#include <sys/mman.h>
#include <xf86drmMode.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <stdexcept>

namespace vitrine::player {

// A dumb buffer of the card. It stays mapped while this lives, even if the card is pulled out.
class MemoryScanout::Buffer {
  public:
    Buffer(const Card& card, int width, int height) : card_(card.fd()), frame_buffers_(card.frame_buffers()) {
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
        frame_buffer_ = frame_buffers_.add({.width = width,
                                            .height = height,
                                            .format = DRM_FORMAT_XRGB8888,
                                            .handles = {handle_},
                                            .pitches = {pitch_}});
        if (frame_buffer_ == 0)
            throw_errno("'{}' takes no buffer of {}x{} px", card.path().string(), width, height);
        std::uint64_t offset = 0;
        if (drmModeMapDumbBuffer(card_, handle_, &offset) != 0)
            throw_errno("map a buffer of '{}'", card.path().string());
        pixels_ =
            ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, card_, static_cast<off_t>(offset));
        if (pixels_ == MAP_FAILED) throw_errno("map a buffer of '{}'", card.path().string());
        std::memset(pixels_, 0, size_);  // makes the kernel allocate all of it before the first picture
    }

    void end() {
        if (pixels_ != MAP_FAILED) ::munmap(pixels_, size_);
        if (frame_buffer_ != 0) frame_buffers_.remove(frame_buffer_);
        if (handle_ != 0) drmModeDestroyDumbBuffer(card_, handle_);
    }

    int card_;
    FrameBuffers& frame_buffers_;  // outlives this
    std::uint32_t handle_ = 0;
    std::uint32_t pitch_ = 0;  // bytes a row
    std::uint64_t size_ = 0;
    std::uint32_t frame_buffer_ = 0;
    void* pixels_ = MAP_FAILED;
};

MemoryScanout::MemoryScanout(const Card& card, int width, int height) : drawn_(width, height) {
    for (auto& buffer : buffers_)
        buffer = std::make_shared<Buffer>(card, width, height);
}

MemoryScanout::~MemoryScanout() = default;

void MemoryScanout::make_current() {
    drawn_.make_current();
}

bool MemoryScanout::has_free_buffer() const {
    return std::ranges::any_of(buffers_, [](const auto& buffer) { return buffer.use_count() == 1; });
}

ScanoutBuffer MemoryScanout::lock_front_buffer() {
    const auto free =
        std::ranges::find_if(buffers_, [](const auto& buffer) { return buffer.use_count() == 1; });
    assert(free != buffers_.end());
    int y = 0;
    drawn_.read([&](std::span<const std::byte> row) { std::ranges::copy(row, (*free)->row(y++)); });
    return {.frame_buffer = (*free)->frame_buffer(), .lease = *free};
}

CardPicture MemoryScanout::picture(const ScanoutBuffer& buffer) {
    const auto shown = std::ranges::find_if(
        buffers_, [&](const auto& one) { return one->frame_buffer() == buffer.frame_buffer; });
    assert(shown != buffers_.end());
    CardPicture picture = pictures_.next(drawn_.width(), drawn_.height());
    for (int y = 0; y < picture.height; ++y)
        std::copy_n((*shown)->row(y), picture.row(y).size(), picture.row(y).begin());
    return picture;
}

}  // namespace vitrine::player
