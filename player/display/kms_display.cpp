#include "player/display/kms_display.hpp"

#include "base/settings/output_words.hpp"
#include "base/system/error.hpp"
#include "base/system/service.hpp"
#include "player/display/gl_device.hpp"

#include <fmt/format.h>
#include <xf86drm.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int ticks_before_asking = 5;  // 2 s each; then dark panels are queried, too
constexpr int ticks_with_old_pictures = 5;
constexpr int ticks_before_mercy = 15;  // then refused modes are tried again

using DeviceHandle = Handle<gbm_device, &gbm_device_destroy>;

// None: the card's GL draws in software.
DeviceHandle open_device(const Card& card, SoftwareGl* software) {
    if (software != nullptr && software->drivers.contains(card.driver())) return nullptr;
    DeviceHandle device(gbm_create_device(card.fd()));
    if (!device) throw_errno("make buffers on '{}'", card.path().string());
    const Egl egl = Egl::on(*device);
    if (!is_software(gl_device())) return device;
    if (software != nullptr) software->drivers.insert(card.driver());
    return nullptr;
}

// Makes the context current.
std::shared_ptr<Egl> make_gl(gbm_device* device, SoftwareGl* software) {
    if (device != nullptr) return std::make_shared<Egl>(Egl::on(*device));
    if (software == nullptr) return std::make_shared<Egl>(Egl::surfaceless());
    if (!software->egl) software->egl = std::make_shared<Egl>(Egl::surfaceless());
    software->egl->make_current(EGL_NO_SURFACE);
    return software->egl;
}

// If systemd holds descriptors over a restart, frame buffers are added through one of them.
Card with_keeper(Card card, UniqueFd& left) {
    if (!service::is_told()) return card;
    const int known = left.get();
    UniqueFd keeper = keeper_of(card.fd(), std::move(left));
    if (keeper.is_open() && keeper.get() != known) service::hold(KmsDisplay::keeper_name, keeper.get());
    card.set_keeper(std::move(keeper));
    return card;
}

// @param are_all  also the panels that are lit already
void let_old_pictures_go(const Card& card, bool are_all) {
    if (!card.frame_buffers().has_old()) return;
    card.frame_buffers().let_go(are_all ? std::vector<std::uint32_t>{} : card.shown());
}

long milliseconds_since(KmsScreen::Time time) {
    return std::chrono::ceil<std::chrono::milliseconds>(std::chrono::steady_clock::now() - time).count();
}

// Opens displays on a graphics card. Keeps software GL, and the keeper from the process before, from display
// to display.
class KmsOpener final : public DisplayOpener {
  public:
    KmsOpener(std::filesystem::path card, const Settings::Output& output)
        : DisplayOpener({}),
          options_{.card = std::move(card),
                   .modes = modes_named(output.mode).value_or(ModeWishes{}),
                   .api = output.api,
                   .software = &software_},
          keeper_(service::held(KmsDisplay::keeper_name)) {}

    std::unique_ptr<Display> open() override { return std::make_unique<KmsDisplay>(options_, keeper_); }

  private:
    SoftwareGl software_;
    KmsOptions options_;
    UniqueFd keeper_;  // from the process before, until a display takes it
};

}  // namespace

std::unique_ptr<DisplayOpener> make_kms_opener(std::optional<std::string_view> argument,
                                               const DisplayRequest& request) {
    if (argument && !argument->starts_with('/')) return nullptr;
    return std::make_unique<KmsOpener>(argument.value_or(""), request.output);
}

KmsDisplay::KmsDisplay(const KmsOptions& options, UniqueFd& left)
    : is_any_card_(options.card.empty()),
      card_(with_keeper(open_card(options.card, options.api), left)),
      device_(open_device(card_, options.software)),
      egl_(make_gl(device_.get(), options.software)),
      surface_{.card = card_, .device = device_.get(), .egl = *egl_},
      watch_(card_.fd()),
      panels_(surface_, options.modes, events_) {
    look_for_panels(KmsPanels::Ask::all);
}

// Without a picture to keep, the card need not stay open.
KmsDisplay::~KmsDisplay() {
    if (!is_kept_) service::forget(keeper_name);
}

std::span<Screen* const> KmsDisplay::screens() {
    take_outcomes();
    if (panels_.take_due_look()) look_for_panels(KmsPanels::Ask::none);
    if (is_gone_ || is_left_ || !is_master_) return {};
    return panels_.screens();
}

void KmsDisplay::dispatch() {
    const PanelWatch::Events events = watch_.read_events();
    if (events.card) {
        for (const std::uint64_t flip : card_.read_flips())
            for (const auto& screen : panels_.lit())
                screen->flipped(flip);
    }
    if (events.panels) {
        panels_.forgive();
        look_for_panels(KmsPanels::Ask::all);
    }
    if (events.tick) on_tick();
}

void KmsDisplay::on_tick() {
    ++ticks_;
    if (ticks_ >= ticks_with_old_pictures) let_old_pictures_go(card_, true);
    if (is_left_ || is_gone_) return;
    if (!is_master_ && card_.take_over()) set_master(true);
    for (const auto& screen : panels_.lit())
        if (screen->give_up_waiting())
            events_.push_back(
                {.is_trouble = true,
                 .text = fmt::format("the card does not report the picture on {}", screen->name())});
    if (ticks_ % ticks_before_mercy == 0) panels_.forgive();
    const bool is_time_to_ask = ticks_ % ticks_before_asking == 0;
    if (!panels_.lit().empty())
        return look_for_panels(is_time_to_ask ? KmsPanels::Ask::unlit : KmsPanels::Ask::none);
    look_for_panels(KmsPanels::Ask::all);
    const bool is_dark = panels_.lit().empty() && is_any_card_ && !is_gone_;
    if (is_dark && is_time_to_ask && is_panel_elsewhere(card_.path()))
        lose_card("given up, as another card has a panel:");
}

void KmsDisplay::look_for_panels(KmsPanels::Ask ask) {
    if (!is_gone_ && !panels_.look(ask)) lose_card("gone:");
}

void KmsDisplay::take_outcomes() {
    for (const auto& screen : panels_.lit()) {
        const KmsScreen::Presented presented = screen->take_presented();
        switch (presented.outcome) {
        case Outcome::nothing:
        case Outcome::under_way:
        case Outcome::dropped:
            break;
        case Outcome::shown:
            let_old_pictures_go(card_, ticks_ >= ticks_with_old_pictures);
            events_.push_back({.text = fmt::format("first picture on {} after {} ms", screen->name(),
                                                   milliseconds_since(screen->awaited_since()))});
            break;
        case Outcome::refused:
            panels_.refuse(*screen, presented.reason);
            break;
        case Outcome::no_master:
            set_master(false);
            break;
        case Outcome::no_card:
            lose_card("gone:");
            break;
        }
    }
}

void KmsDisplay::set_master(bool is_master) {
    if (is_master == is_master_) return;
    is_master_ = is_master;
    panels_.start_over();
    events_.push_back(
        {.is_trouble = !is_master,
         .text = is_master ? "another program has left the card" : "another program has taken the card"});
}

void KmsDisplay::leave() {
    is_left_ = true;
    (void)drmDropMaster(card_.fd());
}

// Another program may be slow to leave the card: if it still has it, the next frame or tick tries again.
void KmsDisplay::take_back() {
    is_left_ = false;
    const bool is_ours = card_.is_ours() || card_.take_over();
    panels_.start_over();
    if (!is_ours) set_master(false);
    look_for_panels(KmsPanels::Ask::all);
}

void KmsDisplay::lose_card(const std::string& why) {
    if (is_gone_) return;
    is_gone_ = true;
    for (const auto& screen : panels_.lit())
        events_.push_back({.text = fmt::format("panel gone from {}", screen->name())});
    events_.push_back({.is_trouble = true, .text = fmt::format("card {} '{}'", why, card_.path().string())});
}

std::string KmsDisplay::description() const {
    const std::string panels = panels_.description();
    return fmt::format("'{}' ({}), {}, {}", card_.path().string(), card_.is_atomic() ? "atomic" : "legacy",
                       panels.empty() ? "no panel yet" : panels, gl_device());
}

}  // namespace vitrine::player
