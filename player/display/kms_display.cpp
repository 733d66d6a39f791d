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

constexpr int ticks_before_asking = 5;  // of 2 s: panels that are dark while others are lit
constexpr int ticks_with_old_pictures = 5;
constexpr int ticks_before_mercy = 15;  // modes that were refused are tried again

using DeviceHandle = Handle<gbm_device, &gbm_device_destroy>;

// Nothing where the card draws in software.
DeviceHandle open_device(const Card& card, SoftwareGl* software) {
    if (software != nullptr && software->drivers.contains(card.driver())) return nullptr;
    DeviceHandle device(gbm_create_device(card.fd()));
    if (!device) throw_errno("make buffers on '{}'", card.path().string());
    const Egl egl = Egl::on(*device);
    if (!is_software(gl_device())) return device;
    if (software != nullptr) software->drivers.insert(card.driver());
    return nullptr;
}

// Current from here on.
std::shared_ptr<Egl> make_gl(gbm_device* device, SoftwareGl* software) {
    if (device != nullptr) return std::make_shared<Egl>(Egl::on(*device));
    if (software == nullptr) return std::make_shared<Egl>(Egl::surfaceless());
    if (!software->egl) software->egl = std::make_shared<Egl>(Egl::surfaceless());
    software->egl->make_current(EGL_NO_SURFACE);
    return software->egl;
}

// Where systemd holds descriptors over a restart, pictures are told to the card through one of them.
Card with_keeper(Card card, UniqueFd& left) {
    if (!service::is_told()) return card;
    const int known = left.get();
    UniqueFd keeper = keeper_of(card.fd(), std::move(left));
    if (keeper.is_open() && keeper.get() != known) service::hold(KmsDisplay::keeper_name, keeper.get());
    card.set_keeper(std::move(keeper));
    return card;
}

std::string mode_name(const Output& output) {
    return fmt::format("{}x{}", output.mode.hdisplay, output.mode.vdisplay);
}

// Keeps, from display to display, GL in software and the keeper that the process before has left.
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
    UniqueFd keeper_;  // of the card, by the process before; until a display takes it
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
      modes_(options.modes),
      device_(open_device(card_, options.software)),
      egl_(make_gl(device_.get(), options.software)),
      surface_{.card = card_, .device = device_.get(), .egl = *egl_},
      watch_(card_.fd()) {
    look_for_panels(Ask::all);
}

// Else what holds the keeper would hold a card that is not used any more.
KmsDisplay::~KmsDisplay() {
    if (!is_kept_) service::forget(keeper_name);
}

std::span<Screen* const> KmsDisplay::screens() {
    take_outcomes();
    if (std::exchange(looks_again_, false)) look_for_panels(Ask::none);
    if (is_gone_ || is_left_ || !is_master_) return {};
    return lent_;
}

void KmsDisplay::dispatch() {
    const PanelWatch::Events events = watch_.take();
    if (events.card) {
        for (const std::uint64_t flip : card_.take_flips())
            for (const auto& screen : lit_)
                screen->flipped(flip);
    }
    if (events.panels) {
        refusals_.clear();
        look_for_panels(Ask::all);
    }
    if (events.tick) on_tick();
}

void KmsDisplay::on_tick() {
    ++ticks_;
    if (ticks_ >= ticks_with_old_pictures) let_old_pictures_go();
    if (is_left_ || is_gone_) return;
    if (!is_master_ && card_.take_over()) set_master(true);
    for (const auto& screen : lit_)
        if (screen->give_up_waiting()) tell(fmt::format("no answer from {}", screen->name()), true);
    if (ticks_ % ticks_before_mercy == 0) refusals_.clear();
    if (!lit_.empty()) return look_for_panels(ticks_ % ticks_before_asking == 0 ? Ask::unlit : Ask::none);
    look_for_panels(Ask::all);
    if (lit_.empty() && is_any_card_ && !is_gone_ && ticks_ % ticks_before_asking == 0 &&
        is_panel_elsewhere(card_.path()))
        be_gone("a panel is at another card than");
}

void KmsDisplay::look_for_panels(Ask ask) {
    if (is_gone_) return;
    const auto is_lit = [&](std::uint32_t connector) {
        return std::ranges::any_of(
            lit_, [&](const auto& screen) { return screen->output().connector == connector; });
    };
    const auto is_asked = [&](std::uint32_t connector) {
        return ask == Ask::all || (ask == Ask::unlit && !is_lit(connector));
    };
    const std::optional<CardState> state = card_.state(is_asked);
    if (!state) return be_gone("gone:");
    for (const CardState::Connector& connector : state->connectors) {
        if (!connector.is_link_bad) continue;
        for (const auto& screen : lit_)
            if (screen->output().connector == connector.id) screen->start_over();
    }
    follow(choose_outputs(*state, modes_, card_.is_atomic(), refusals_), *state);
}

// What is lit and shall be stays as it is: its panel notices nothing of what becomes of others.
void KmsDisplay::follow(const std::vector<Output>& outputs, const CardState& state) {
    const auto is_wanted = [&](const std::unique_ptr<KmsScreen>& screen) {
        return std::ranges::any_of(outputs,
                                   [&](const Output& output) { return output.is_same(screen->output()); });
    };
    lent_.clear();
    for (const auto& screen : lit_)
        if (!is_wanted(screen)) tell(fmt::format("panel gone from {}", screen->name()));
    std::erase_if(lit_, [&](const auto& screen) { return !is_wanted(screen); });
    for (const Output& output : outputs) {
        const bool is_lit =
            std::ranges::any_of(lit_, [&](const auto& screen) { return screen->output().is_same(output); });
        if (!is_lit) light(output, state, outputs);
    }
    for (const Output& output : outputs)
        for (const auto& screen : lit_)
            if (screen->output().connector == output.connector) lent_.push_back(screen.get());
    if (lit_.empty() && !is_told_dark_) tell("no panel");
    is_told_dark_ = lit_.empty();
}

void KmsDisplay::light(const Output& output, const CardState& state, const std::vector<Output>& all) {
    try {
        lit_.push_back(std::make_unique<KmsScreen>(surface_, output, obstacles(state, output, all)));
        tell(fmt::format("visible {} on {} at {:.2f} Hz", mode_name(output), output.name,
                         refresh_rate(output.mode)));
    } catch (const std::runtime_error& error) {
        tell(fmt::format("{} stays dark in {}: {}", output.name, mode_name(output), error.what()), true);
        ++refusals_[output.connector];
        looks_again_ = true;
    }
}

void KmsDisplay::take_outcomes() {
    for (const auto& screen : lit_) {
        switch (screen->take_outcome()) {
        case Outcome::nothing:
        case Outcome::under_way:
        case Outcome::dropped:
            break;
        case Outcome::shown:
            tell_shown(*screen);
            break;
        case Outcome::refused:
            refuse(*screen);
            break;
        case Outcome::no_master:
            set_master(false);
            break;
        case Outcome::no_card:
            be_gone("gone:");
            break;
        }
    }
}

void KmsDisplay::refuse(const KmsScreen& screen) {
    tell(fmt::format("{} refuses {}: {}", screen.name(), mode_name(screen.output()), screen.reason()), true);
    ++refusals_[screen.output().connector];
    looks_again_ = true;
}

void KmsDisplay::tell_shown(const KmsScreen& screen) {
    const auto since = std::chrono::steady_clock::now() - screen.awaited_since();
    let_old_pictures_go();
    tell(fmt::format("first picture on {} after {} ms", screen.name(),
                     std::chrono::ceil<std::chrono::milliseconds>(since).count()));
}

void KmsDisplay::let_old_pictures_go() {
    if (!has_old_picture()) return;
    const bool are_all = ticks_ >= ticks_with_old_pictures;
    card_.frame_buffers().let_go(are_all ? std::vector<std::uint32_t>{} : card_.shown());
}

void KmsDisplay::set_master(bool is_master) {
    if (is_master == is_master_) return;
    is_master_ = is_master;
    for (const auto& screen : lit_)
        screen->start_over();
    tell(is_master ? "master regained" : "master lost", !is_master);
}

void KmsDisplay::leave() {
    is_left_ = true;
    (void)drmDropMaster(card_.fd());
}

// Where that fails somebody is slow to leave it: the next picture or the next tick asks again.
void KmsDisplay::take_back() {
    is_left_ = false;
    const bool is_ours = card_.is_ours() || card_.take_over();
    for (const auto& screen : lit_)
        screen->start_over();
    if (!is_ours) set_master(false);
    look_for_panels(Ask::all);
}

void KmsDisplay::be_gone(std::string why) {
    if (is_gone_) return;
    is_gone_ = true;
    for (const auto& screen : lit_)
        tell(fmt::format("panel gone from {}", screen->name()));
    tell(fmt::format("card {} '{}'", why, card_.path().string()), true);
}

void KmsDisplay::tell(std::string text, bool is_trouble) {
    events_.push_back({.is_trouble = is_trouble, .text = std::move(text)});
}

std::string KmsDisplay::description() const {
    std::string panels;
    for (const auto& screen : lit_)
        panels += fmt::format(", {} {} at {:.2f} Hz", screen->name(), mode_name(screen->output()),
                              refresh_rate(screen->output().mode));
    return fmt::format("'{}' ({}){}, {}", card_.path().string(), card_.is_atomic() ? "atomic" : "legacy",
                       panels.empty() ? ", no panel yet" : panels, gl_device());
}

}  // namespace vitrine::player
