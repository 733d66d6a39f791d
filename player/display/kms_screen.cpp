#include "player/display/kms_screen.hpp"

#include "base/system/error.hpp"
#include "base/system/log.hpp"

#include <fmt/format.h>
#include <xf86drm.h>

#include <cassert>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace vitrine {

namespace {

constexpr int most_ticks_in_flight = 2;  // a flip that is not answered by then never will be

using DeviceHandle = Handle<gbm_device, &gbm_device_destroy>;
using CrtcHandle = Handle<drmModeCrtc, &drmModeFreeCrtc>;

// The card's copy of a mode.
class ModeBlob {
  public:
    ModeBlob(int card, const drmModeModeInfo& mode) : card_(card) {
        if (drmModeCreatePropertyBlob(card_, &mode, sizeof mode, &id_) != 0)
            throw_errno("hand the mode '{}' to the graphics card", mode.name);
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

DeviceHandle open_device(const Card& card) {
    DeviceHandle device(gbm_create_device(card.fd()));
    if (!device) throw_errno("make buffers on '{}'", card.path().string());
    return device;
}

bool is_loss_of_master(int error) {
    return error == EACCES || error == EPERM;
}

}  // namespace

// Puts back at its end what was shown before, the console as a rule; what fails then is of no use to anyone.
struct KmsScreen::SavedCrtc {
    SavedCrtc(int fd, const Output& output)
        : card(fd), connector(output.connector), crtc(drmModeGetCrtc(fd, output.crtc)) {}

    SavedCrtc(const SavedCrtc&) = delete;
    SavedCrtc& operator=(const SavedCrtc&) = delete;
    SavedCrtc(SavedCrtc&&) = delete;
    SavedCrtc& operator=(SavedCrtc&&) = delete;

    ~SavedCrtc() {
        if (!crtc || !crtc->mode_valid || crtc->buffer_id == 0) return;
        drmModeSetCrtc(card, crtc->crtc_id, crtc->buffer_id, crtc->x, crtc->y, &connector, 1, &crtc->mode);
    }

    int card;
    std::uint32_t connector;
    CrtcHandle crtc;
};

KmsScreen::KmsScreen(const KmsOptions& options)
    : card_(open_card(options.card, options.api)),
      wish_(options.wish),
      device_(open_device(card_)),
      egl_(Egl::on(*device_)),
      watch_(card_.fd()) {
    look_for_panel(true);
}

KmsScreen::~KmsScreen() {
    before_.reset();  // the panel lets go of our buffers before they end
    go_dark();
}

void KmsScreen::begin_frame() {
    assert(scanout_);
    scanout_->make_current();
}

// A picture that the card has no time for is dropped: the next one is newer.
void KmsScreen::present(std::chrono::nanoseconds) {
    assert(scanout_ && !in_flight_);
    ScanoutBuffer buffer = scanout_->take();
    if (!needs_mode_) {
        const int error = flip(buffer);
        if (error == 0) in_flight_ = std::move(buffer);
        take_result(error, "show a picture");
        return;
    }
    const int error = set_mode(buffer);
    if (error == 0) {
        on_screen_ = std::move(buffer);
        needs_mode_ = false;
        has_shown_ = true;
        const auto since = std::chrono::steady_clock::now() - found_;
        tell(fmt::format("first picture on {} after {} ms", output_->name,
                         std::chrono::ceil<std::chrono::milliseconds>(since).count()));
    }
    take_result(error, "set the mode");
}

void KmsScreen::take_result(int error, const char* what) {
    if (error == 0 || error == EBUSY || error == EINTR || error == EAGAIN) return;
    log::debug("'{}': cannot {}: {}", card_.path().string(), what, std::generic_category().message(error));
    if (is_loss_of_master(error)) {
        set_master(false);
        needs_mode_ = true;
        return;
    }
    if (!has_shown_) {
        errno = error;
        throw_errno("{} {} on '{}' at '{}'", what, output_->mode.name, output_->name, card_.path().string());
    }
    go_dark();  // the panel is not what it was: the next tick looks again
}

int KmsScreen::set_mode(const ScanoutBuffer& buffer) {
    if (!before_) before_ = std::make_unique<SavedCrtc>(card_.fd(), *output_);
    if (!card_.is_atomic())
        return -drmModeSetCrtc(card_.fd(), output_->crtc, buffer.frame_buffer(), 0, 0, &output_->connector, 1,
                               &output_->mode);
    // Blocking and without an event: some drivers never come back from a mode that is set in passing.
    const ModeBlob mode(card_.fd(), output_->mode);
    return card_.commit(modeset_request(*output_, properties_, mode.id(), buffer.frame_buffer()),
                        DRM_MODE_ATOMIC_ALLOW_MODESET, nullptr);
}

int KmsScreen::flip(const ScanoutBuffer& buffer) {
    ticks_in_flight_ = 0;
    if (!card_.is_atomic())
        return -drmModePageFlip(card_.fd(), output_->crtc, buffer.frame_buffer(), DRM_MODE_PAGE_FLIP_EVENT,
                                this);
    return card_.commit(flip_request(*output_, properties_, buffer.frame_buffer()),
                        DRM_MODE_ATOMIC_NONBLOCK | DRM_MODE_PAGE_FLIP_EVENT, this);
}

// The event means that the picture before is free again, not that time has passed: some cards send it at
// once.
void KmsScreen::flipped(int, unsigned, unsigned, unsigned, void* screen) {
    auto& self = *static_cast<KmsScreen*>(screen);
    if (!self.in_flight_) return;  // of a panel that has gone since
    self.on_screen_ = std::exchange(self.in_flight_, std::nullopt);
}

void KmsScreen::dispatch() {
    const PanelWatch::Events events = watch_.take();
    if (events.card) {
        drmEventContext context{};
        context.version = 2;
        context.page_flip_handler = &flipped;
        drmHandleEvent(card_.fd(), &context);
    }
    if (events.panels) look_for_panel(true);
    if (events.tick) on_tick();
}

void KmsScreen::on_tick() {
    if (in_flight_ && ++ticks_in_flight_ > most_ticks_in_flight) {
        in_flight_.reset();
        needs_mode_ = true;
    }
    if (!is_master_ && drmSetMaster(card_.fd()) == 0) set_master(true);
    look_for_panel(!output_);
}

void KmsScreen::look_for_panel(bool asks_panels) {
    const std::optional<Output> found = choose_output(card_.state(asks_panels), wish_, card_.is_atomic());
    if (output_ && found ? output_->is_same(*found) : !output_ && !found) return;
    if (output_) tell(fmt::format("panel gone from {}", output_->name));
    go_dark();
    if (found) light(*found);
}

void KmsScreen::tell(std::string text, bool is_trouble) {
    events_.push_back({.is_trouble = is_trouble, .text = std::move(text)});
}

void KmsScreen::set_master(bool is_master) {
    is_master_ = is_master;
    found_ = std::chrono::steady_clock::now();
    tell(is_master ? "master regained" : "master lost", !is_master);
}

void KmsScreen::light(const Output& output) {
    width_ = output.mode.hdisplay;
    height_ = output.mode.vdisplay;
    if (card_.is_atomic()) properties_ = card_.properties(output);
    scanout_.emplace(card_, *device_, egl_, width_, height_);
    output_ = output;
    needs_mode_ = true;
    found_ = std::chrono::steady_clock::now();
    tell(fmt::format("visible {}x{} on {} at {:.2f} Hz", width_, height_, output.name,
                     refresh_rate(output.mode)));
}

void KmsScreen::go_dark() {
    output_.reset();
    in_flight_.reset();
    on_screen_.reset();
    scanout_.reset();
}

std::string KmsScreen::description() const {
    const char* const api = card_.is_atomic() ? "atomic" : "legacy";
    const std::string panel = output_ ? fmt::format("{}, {} px at {:.2f} Hz", output_->name,
                                                    output_->mode.name, refresh_rate(output_->mode))
                                      : std::string("no panel yet");
    return fmt::format("'{}' ({}), {}, {}", card_.path().string(), api, panel, egl_.renderer());
}

std::unique_ptr<KmsScreen> make_kms(const KmsOptions& options) {
    return std::make_unique<KmsScreen>(options);
}

}  // namespace vitrine
