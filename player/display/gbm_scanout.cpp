#include "player/display/gbm_scanout.hpp"

#include "base/system/error.hpp"

#include <drm_fourcc.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace vitrine::player {

namespace {

// The card's number for a buffer. Removed when the buffer is destroyed.
struct FrameBuffer {
    FrameBuffer(FrameBuffers& of, std::uint32_t number) : all(of), id(number) {}

    FrameBuffer(const FrameBuffer&) = delete;
    FrameBuffer& operator=(const FrameBuffer&) = delete;
    FrameBuffer(FrameBuffer&&) = delete;
    FrameBuffer& operator=(FrameBuffer&&) = delete;

    ~FrameBuffer() { all.remove(id); }

    FrameBuffers& all;  // outlives this
    std::uint32_t id;
};

void end_frame_buffer(gbm_bo*, void* data) {
    const std::unique_ptr<FrameBuffer> ending(static_cast<FrameBuffer*>(data));
}

// Names modifiers only if both sides know them: some cards refuse even "unknown".
std::unique_ptr<FrameBuffer> announce(const Card& card, gbm_bo& buffer) {
    const std::uint64_t modifier = gbm_bo_get_modifier(&buffer);
    BufferForm form{.width = gbm_bo_get_width(&buffer),
                    .height = gbm_bo_get_height(&buffer),
                    .format = GBM_FORMAT_XRGB8888,
                    .is_modifier_named = card.has_modifiers() && modifier != DRM_FORMAT_MOD_INVALID};
    const int planes = gbm_bo_get_plane_count(&buffer);
    for (int i = 0; i < planes && i < 4; ++i) {
        const auto plane = static_cast<std::size_t>(i);
        form.handles[plane] = gbm_bo_get_handle_for_plane(&buffer, i).u32;
        form.pitches[plane] = gbm_bo_get_stride_for_plane(&buffer, i);
        form.offsets[plane] = gbm_bo_get_offset(&buffer, i);
        form.modifiers[plane] = modifier;
    }
    const std::uint32_t id = card.frame_buffers().add(form);
    if (id == 0)
        throw_errno("'{}' takes no buffer of {}x{} px", card.path().string(), form.width, form.height);
    return std::make_unique<FrameBuffer>(card.frame_buffers(), id);
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

ScanoutBuffer GbmScanout::lock_front_buffer() {
    if (!eglSwapBuffers(egl_.display(), window_)) throw_egl("end a frame");
    gbm_bo* const buffer = gbm_surface_lock_front_buffer(surface_.get());
    if (!buffer) throw_errno("lock a buffer of '{}'", card_.path().string());
    const std::shared_ptr<gbm_bo> lease(
        buffer, [surface = surface_.get()](gbm_bo* lent) { gbm_surface_release_buffer(surface, lent); });
    auto* known = static_cast<FrameBuffer*>(gbm_bo_get_user_data(buffer));
    if (!known) {
        known = announce(card_, *buffer).release();
        gbm_bo_set_user_data(buffer, known, &end_frame_buffer);  // takes `known`
    }
    return {.frame_buffer = known->id, .lease = lease};
}

CardPicture GbmScanout::picture(const ScanoutBuffer& buffer) {
    auto* const shown = const_cast<gbm_bo*>(static_cast<const gbm_bo*>(buffer.lease.get()));
    CardPicture picture =
        pictures_.next(static_cast<int>(gbm_bo_get_width(shown)), static_cast<int>(gbm_bo_get_height(shown)));
    void* mapping = nullptr;
    std::uint32_t stride = 0;
    const auto* const first = static_cast<const std::byte*>(
        gbm_bo_map(shown, 0, 0, gbm_bo_get_width(shown), gbm_bo_get_height(shown), GBM_BO_TRANSFER_READ,
                   &stride, &mapping));
    if (first == nullptr) throw_errno("read a buffer of '{}'", card_.path().string());
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(first + static_cast<std::size_t>(y) * stride, picture.row(y).size(),
                    picture.row(y).begin());
    gbm_bo_unmap(shown, mapping);
    return picture;
}

}  // namespace vitrine::player
