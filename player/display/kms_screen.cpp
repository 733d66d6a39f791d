#include "player/display/kms_screen.hpp"

#include "base/system/error.hpp"
#include "base/system/handle.hpp"
#include "player/display/gbm_scanout.hpp"
#include "player/display/memory_scanout.hpp"

#include <fmt/format.h>

#include <cassert>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace vitrine::player {

namespace {

// A mode in the card's memory.
class ModeBlob {
  public:
    ModeBlob(int card, const drmModeModeInfo& mode) : card_(card) {
        if (drmModeCreatePropertyBlob(card_, &mode, sizeof mode, &id_) != 0)
            throw_errno("give the mode '{}' to the graphics card", mode.name);
    }

    ModeBlob(const ModeBlob&) = delete;
    ModeBlob& operator=(const ModeBlob&) = delete;
    ModeBlob(ModeBlob&&) = delete;
    ModeBlob& operator=(ModeBlob&&) = delete;

    ~ModeBlob() { drmModeDestroyPropertyBlob(card_, id_); }

    std::uint32_t id() const { return id_; }

  private:
    int card_;
    std::uint32_t id_ = 0;
};

std::unique_ptr<Scanout> make_scanout(const KmsSurface& surface, int width, int height) {
    if (surface.device == nullptr) return std::make_unique<MemoryScanout>(surface.card, width, height);
    return std::make_unique<GbmScanout>(surface.card, *surface.device, surface.egl, width, height);
}

}  // namespace

KmsScreen::KmsScreen(KmsSurface& surface, const Output& output, const Obstacles& in_the_way)
    : Screen(output.millimetres),
      surface_(surface),
      output_(output),
      in_the_way_(in_the_way),
      scanout_(make_scanout(surface, output.mode.hdisplay, output.mode.vdisplay)) {
    if (surface.card.is_atomic()) properties_ = surface.card.properties(output);
}

// A flip that is under way is waited for by the card. A card that is busy or another's is asked again.
void KmsScreen::turn_off() {
    if (is_off_) return;
    const Card& card = surface_.card;
    const int error = card.is_atomic()
                          ? card.commit(off_request(output_, properties_), DRM_MODE_ATOMIC_ALLOW_MODESET, 0)
                          : -drmModeSetCrtc(card.fd(), output_.crtc, 0, 0, 0, nullptr, 0, nullptr);
    if (error != 0) return;
    state_.start_over();
    is_off_ = true;
}

void KmsScreen::begin_frame() {
    scanout_->make_current();
}

// A card that has no room for another picture, or was pulled out, fails already when the drawing ends.
void KmsScreen::present(std::chrono::nanoseconds) {
    assert(!state_.is_waiting());
    if (std::exchange(is_off_, false)) awaited_since_ = std::chrono::steady_clock::now();
    try {
        show(scanout_->lock_front_buffer());
    } catch (const std::runtime_error& error) {
        presented_ = {.outcome = Outcome::refused, .reason = error.what()};
    }
    is_lost_ = presented_.outcome != Outcome::under_way && presented_.outcome != Outcome::shown;
}

void KmsScreen::show(ScanoutBuffer buffer) {
    const bool comes_with_mode = state_.needs_mode();
    const int error = request(buffer, comes_with_mode);
    const Outcome outcome = comes_with_mode ? state_.mode_answered(error)
                                            : state_.flip_answered(error, std::chrono::steady_clock::now());
    presented_ = {.outcome = outcome, .reason = error == 0 ? "" : std::generic_category().message(error)};
    if (outcome == Outcome::under_way) {
        in_flight_ = std::move(buffer);
    } else if (outcome == Outcome::shown) {
        in_flight_.reset();
        on_screen_ = std::move(buffer);
        in_the_way_ = {};
        ++flips_;
    }
}

std::optional<CardPicture> KmsScreen::shown() {
    const Handle<drmModeCrtc, &drmModeFreeCrtc> crtc(drmModeGetCrtc(surface_.card.fd(), output_.crtc));
    if (!crtc) throw_errno("ask '{}' what {} shows", surface_.card.path().string(), name());
    for (const auto* buffer : {&on_screen_, &in_flight_})
        if (*buffer && (*buffer)->frame_buffer == crtc->buffer_id) return scanout_->picture(**buffer);
    if (!on_screen_) return std::nullopt;
    throw std::runtime_error(fmt::format("{} shows another program's picture", name()));
}

int KmsScreen::request(const ScanoutBuffer& buffer, bool has_mode) {
    const Card& card = surface_.card;
    if (!has_mode) {
        flip_ = ++surface_.flips;
        if (!card.is_atomic()) return card.flip(output_.crtc, buffer.frame_buffer, flip_);
        return card.commit(flip_request(output_, properties_, buffer.frame_buffer),
                           DRM_MODE_ATOMIC_NONBLOCK | DRM_MODE_PAGE_FLIP_EVENT, flip_);
    }
    if (!card.is_atomic())
        return -drmModeSetCrtc(card.fd(), output_.crtc, buffer.frame_buffer, 0, 0, &output_.connector, 1,
                               &output_.mode);
    const ModeBlob mode(card.fd(), output_.mode);
    return card.commit(modeset_request(output_, properties_, mode.id(), buffer.frame_buffer, in_the_way_),
                       DRM_MODE_ATOMIC_ALLOW_MODESET, 0);
}

KmsScreen::Presented KmsScreen::take_presented() {
    return std::exchange(presented_, {});
}

// The event means that the picture before is free again, not that time has passed: some cards send it at
// once.
void KmsScreen::flipped(std::uint64_t flip) {
    if (flip != flip_ || !state_.flip_arrived()) return;
    ++flips_;
    on_screen_ = std::exchange(in_flight_, std::nullopt);
}

bool KmsScreen::give_up_waiting() {
    return state_.give_up_waiting(std::chrono::steady_clock::now());
}

void KmsScreen::start_over() {
    state_.start_over();
    awaited_since_ = std::chrono::steady_clock::now();
}

}  // namespace vitrine::player
