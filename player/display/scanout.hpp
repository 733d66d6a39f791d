#pragma once

#include "player/display/card.hpp"
#include "player/display/egl.hpp"

#include "base/system/handle.hpp"

#include <gbm.h>

namespace vitrine {

/// One finished picture in the card's memory, lent by a Scanout, which outlives it; given back at its end.
class ScanoutBuffer {
  public:
    ScanoutBuffer(gbm_surface& surface, gbm_bo& buffer, std::uint32_t frame_buffer);
    ScanoutBuffer(ScanoutBuffer&& other) noexcept;
    ScanoutBuffer(const ScanoutBuffer&) = delete;
    ScanoutBuffer& operator=(const ScanoutBuffer&) = delete;
    ScanoutBuffer& operator=(ScanoutBuffer&& other) noexcept;
    ~ScanoutBuffer();

    /// The card's number for it.
    std::uint32_t frame_buffer() const { return frame_buffer_; }

  private:
    gbm_surface* surface_;
    gbm_bo* buffer_;  // nullptr: moved away
    std::uint32_t frame_buffer_;
};

/// The buffers that GL draws to and a card shows, of one size. Ends after every buffer it lent.
class Scanout {
  public:
    /// @param card, device, egl  outlive this
    /// @throws std::runtime_error where the card has no room or no such format
    Scanout(const Card& card, gbm_device& device, Egl& egl, int width, int height);
    Scanout(const Scanout&) = delete;
    Scanout& operator=(const Scanout&) = delete;
    Scanout(Scanout&&) = delete;
    Scanout& operator=(Scanout&&) = delete;
    ~Scanout();

    /// Directs what is drawn to the next buffer.
    void make_current();

    /// Whether a next buffer is there to draw to.
    bool has_free_buffer() const { return gbm_surface_has_free_buffers(surface_.get()) > 0; }

    /// Ends the drawing: what was drawn, ready to be shown.
    ScanoutBuffer take();

  private:
    const Card& card_;
    Egl& egl_;
    Handle<gbm_surface, &gbm_surface_destroy> surface_;
    EGLSurface window_;
};

}  // namespace vitrine
