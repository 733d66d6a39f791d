#pragma once

#include "player/display/card.hpp"
#include "player/display/egl.hpp"
#include "player/display/scanout.hpp"

#include "base/system/handle.hpp"

#include <gbm.h>

namespace vitrine::player {

/// Buffers of the graphics card. GL draws directly to them.
class GbmScanout final : public Scanout {
  public:
    /// @param card, device, egl  outlive this; egl belongs to the device
    /// @throws std::runtime_error if the card has no room or no such format
    GbmScanout(const Card& card, gbm_device& device, Egl& egl, int width, int height);
    GbmScanout(const GbmScanout&) = delete;
    GbmScanout& operator=(const GbmScanout&) = delete;
    GbmScanout(GbmScanout&&) = delete;
    GbmScanout& operator=(GbmScanout&&) = delete;
    ~GbmScanout() override;

    void make_current() override;

    bool has_free_buffer() const override { return gbm_surface_has_free_buffers(surface_.get()) > 0; }

    ScanoutBuffer lock_front_buffer() override;
    CardPicture picture(const ScanoutBuffer& buffer) override;

  private:
    const Card& card_;
    Egl& egl_;
    Handle<gbm_surface, &gbm_surface_destroy> surface_;
    EGLSurface window_;
    CardPictureMemory pictures_;
};

}  // namespace vitrine::player
