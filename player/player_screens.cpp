#include "base/state/screen_note.hpp"
#include "base/system/log.hpp"
#include "player/player.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

// Which screens which stages have, and the terminal below them.

namespace vitrine::player {

void Player::follow_display(std::chrono::nanoseconds time) {
    if (display_) {
        give_screens(time);
        for (const DisplayEvent& event : display_->take_events())
            log::write(event.is_trouble ? log::Level::warning : log::Level::info, "screen: " + event.text);
        if (display_->is_gone()) close_display();
    }
    if (display_ || EventLoop::Clock::now() < next_try_) return;
    open_display();
    if (display_) give_screens(time);
}

void Player::give_screens(std::chrono::nanoseconds time) {
    std::vector<std::vector<Screen*>> screens(stages_.size());
    for (Screen* screen : display_->screens()) {
        const auto found = stage_of_.find(screen->name());
        screens[found == stage_of_.end() ? 0 : found->second].push_back(screen);
    }
    for (std::size_t i = 0; i < stages_.size(); ++i)
        stages_[i]->set_screens(std::move(screens[i]), time);
    note_screens();
}

/// For the analyzer, whose clips need not be larger than they are shown.
void Player::note_screens() {
    int side = 0;
    for (const Screen* screen : display_->screens())
        side = std::max({side, screen->width(), screen->height()});
    if (side == 0 || side == std::exchange(noted_side_, side)) return;
    try {
        note_screen_side(settings_.state.directory, side);
    } catch (const std::system_error& error) {
        log::warning("the analyzer is not told how large the screens are: {}", error.what());
    }
}

void Player::leave_terminal() {
    if (display_) display_->leave();
    visitors_.leave();
    log::info("screen: left to another terminal");
    if (console_) console_->leave();
}

void Player::come_to_terminal() {
    if (console_) console_->enter();
    visitors_.come_back();
    log::info("screen: back from another terminal");
    if (display_) display_->take_back();
}

}  // namespace vitrine::player
