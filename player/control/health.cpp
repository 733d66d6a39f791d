#include "player/control/health.hpp"

#include <algorithm>

namespace vitrine::player {

const char* name_of(ShowState state) {
    switch (state) {
    case ShowState::showing:
        return "showing";
    case ShowState::no_content:
        return "no content";
    case ShowState::no_panel:
        return "no panel";
    case ShowState::off:
        return "off";
    case ShowState::no_flip:
        break;
    }
    return "no flip";
}

void Health::set_screens(const ScreenState& now_seen, Duration now) {
    std::map<std::string, Screen> seen;
    for (const ScreenState::Screen& screen : now_seen.screens) {
        const auto known = screens_.find(screen.name);
        Screen next = known == screens_.end() ? Screen{.flips = screen.flips, .last = now} : known->second;
        if (next.flips != screen.flips) next = {.flips = screen.flips, .last = now, .has_flipped = true};
        seen.emplace(screen.name, next);
    }
    screens_ = std::move(seen);
    if (now_seen.is_away)
        state_ = ShowState::off;
    else if (screens_.empty())
        state_ = ShowState::no_panel;
    else if (since_flip(now) > patience)
        state_ = ShowState::no_flip;
    else
        state_ = now_seen.items > 0 ? ShowState::showing : ShowState::no_content;
}

Health::Duration Health::since_flip(Duration now) const {
    Duration longest{0};
    for (const auto& [name, screen] : screens_)
        longest = std::max(longest, now - screen.last);
    return longest;
}

bool Health::feed_watchdog_now(Duration now) {
    if (now - fed_ < period) return false;
    const bool is_dark = state_ == ShowState::off || state_ == ShowState::no_panel;
    const bool has_flipped =
        std::ranges::all_of(screens_, [](const auto& entry) { return entry.second.has_flipped; });
    if (!is_dark && !has_flipped) return false;
    for (auto& [name, screen] : screens_)
        screen.has_flipped = false;
    fed_ = now;
    return true;
}

}  // namespace vitrine::player
