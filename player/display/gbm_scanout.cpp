#include "player/display/gbm_scanout.hpp"

#include "base/system/error.hpp"

#include <drm_fourcc.h>
#include <xf86drmMode.h>

#include <array>
#include <memory>

namespace vitrine {

namespace {

// The card's number for a buffer, which ends with the buffer.
struct FrameBuffer {
    FrameBuffer(int card, std::uint32_t number) : fd(card), id(number) {}

    FrameBuffer(const FrameBuffer&) = delete;
    FrameBuffer& operator=(const FrameBuffer&) = delete;
    FrameBuffer(FrameBuffer&&) = delete;
    FrameBuffer& operator=(FrameBuffer&&) = delete;

    ~FrameBuffer() { drmModeRmFB(fd, id); }

    int fd;
    std::uint32_t id;
};

void end_frame_buffer(gbm_bo*, void* data) {
    const std::unique_ptr<FrameBuffer> ending(static_cast<FrameBuffer*>(data));
}

// Modifiers are named only where both sides know them: some cards refuse even "unknown".
std::unique_ptr<FrameBuffer> announce(const Card& card, gbm_bo& buffer) {
    std::array<std::uint32_t, 4> handles{};
    std::array<std::uint32_t, 4> strides{};
    std::array<std::uint32_t, 4> offsets{};
    std::array<std::uint64_t, 4> modifiers{};
    const std::uint64_t modifier = gbm_bo_get_modifier(&buffer);
    const int planes = gbm_bo_get_plane_count(&buffer);
    for (int i = 0; i < planes && i < 4; ++i) {
        const auto plane = static_cast<std::size_t>(i);
        handles[plane] = gbm_bo_get_handle_for_plane(&buffer, i).u32;
        strides[plane] = gbm_bo_get_stride_for_plane(&buffer, i);
        offsets[plane] = gbm_bo_get_offset(&buffer, i);
        modifiers[plane] = modifier;
    }
    const std::uint32_t width = gbm_bo_get_width(&buffer);
    const std::uint32_t height = gbm_bo_get_height(&buffer);
    std::uint32_t id = 0;
    const bool is_named = card.has_modifiers() && modifier != DRM_FORMAT_MOD_INVALID;
    const int result = is_named ? drmModeAddFB2WithModifiers(card.fd(), width, height, GBM_FORMAT_XRGB8888,
                                                             handles.data(), strides.data(), offsets.data(),
                                                             modifiers.data(), &id, DRM_MODE_FB_MODIFIERS)
                                : drmModeAddFB2(card.fd(), width, height, GBM_FORMAT_XRGB8888, handles.data(),
                                                strides.data(), offsets.data(), &id, 0);
    if (result != 0) throw_errno("'{}' takes no buffer of {}x{} px", card.path().string(), width, height);
    return std::make_unique<FrameBuffer>(card.fd(), id);
}

}  // namespace

GbmScanout::GbmScanout(const Card& card, gbm_device& device, Egl& egl, int width, int height)
    : card_(card),
      egl_(egl),
      surface_(gbm_surface_create(&device, static_cast<std::uint32_t>(width),
                                  static_cast<std::uint32_t>(height), GBM_FORMAT_XRGB8888,
                                  GBM_BO_USE_SCANOUT | GBM_BO_USE_RENDERING)) {
    if (!surface_) throw_errno("make buffers of {}x{} px on '{}'", width, height, card.path().string());
    window_ = eglCreatePlatformWindowSurface(egl.display(), egl.config(), surface_.get(), nullptr);
    if (window_ == EGL_NO_SURFACE) throw_egl("make an EGL surface of the card's buffers");
}

GbmScanout::~GbmScanout() {
    eglMakeCurrent(egl_.display(), EGL_NO_SURFACE, EGL_NO_SURFACE, eglGetCurrentContext());
    eglDestroySurface(egl_.display(), window_);
}

void GbmScanout::make_current() {
    egl_.make_current(window_);
}

ScanoutBuffer GbmScanout::take() {
    if (!eglSwapBuffers(egl_.display(), window_)) throw_egl("end a frame");
    gbm_bo* const buffer = gbm_surface_lock_front_buffer(surface_.get());
    if (!buffer) throw_errno("lock a buffer of '{}'", card_.path().string());
    const std::shared_ptr<gbm_bo> lease(
        buffer, [surface = surface_.get()](gbm_bo* lent) { gbm_surface_release_buffer(surface, lent); });
    auto* known = static_cast<FrameBuffer*>(gbm_bo_get_user_data(buffer));
    if (!known) {
        known = announce(card_, *buffer).release();
        gbm_bo_set_user_data(buffer, known, &end_frame_buffer);  // owns it from here on
    }
    return {.frame_buffer = known->id, .lease = lease};
}

Picture GbmScanout::picture(const ScanoutBuffer& buffer) const {
    auto* const shown = const_cast<gbm_bo*>(static_cast<const gbm_bo*>(buffer.lease.get()));
    Picture picture{.width = static_cast<int>(gbm_bo_get_width(shown)),
                    .height = static_cast<int>(gbm_bo_get_height(shown)),
                    .pixels = {}};
    void* mapping = nullptr;
    std::uint32_t stride = 0;
    const auto* const first = static_cast<const std::byte*>(
        gbm_bo_map(shown, 0, 0, gbm_bo_get_width(shown), gbm_bo_get_height(shown), GBM_BO_TRANSFER_READ,
                   &stride, &mapping));
    if (first == nullptr) throw_errno("read a buffer of '{}'", card_.path().string());
    for (int y = 0; y < picture.height; ++y)
        append_xrgb(first + static_cast<std::size_t>(y) * stride, picture.width, picture.pixels);
    gbm_bo_unmap(shown, mapping);
    return picture;
}

}  // namespace vitrine
