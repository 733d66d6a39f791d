#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace vitrine::player {

/// The state of the screens, as somebody sees it from across the room.
enum class ShowState {
    showing,     // pictures reach every display
    no_content,  // pictures reach them, but there is no file to show: the idle picture
    no_panel,    // there is no display, or no graphics card
    off,         // on purpose: another terminal or another program has the display
    no_flip,     // a display is there and takes no picture
};

/// "showing", "no content", "no panel", "off", "no flip".
const char* name_of(ShowState state);

/// The screens at one moment.
struct ScreenState {
    struct Screen {
        std::string name;
        std::uint64_t flips = 0;  // pictures that have reached it so far
    };

    std::span<const Screen> screens;  // lent
    bool is_away = false;             // the display is left to others
    std::size_t items = 0;            // on the wall
};

/// Tells whether pictures reach the displays, and so whether systemd's watchdog may be fed: since it was fed
/// last a picture must have reached each display, or there must be no display on purpose. A main loop that
/// stands still feeds nothing. Knows no clock: the time is passed in.
class Health {
  public:
    using Duration = std::chrono::nanoseconds;

    static constexpr Duration patience = std::chrono::seconds(5);  // between two pictures of a display
    static constexpr Duration period = std::chrono::seconds(1);    // at least, from one feeding to the next

    /// To be called at every tick.
    void set_screens(const ScreenState& screens, Duration now);

    ShowState state() const { return state_; }

    /// The longest time that a display has waited for a picture; zero where there is no display.
    Duration since_flip(Duration now) const;

    /// To be called after each set_screens(). @return  true: feed the watchdog now; the next period begins
    bool feed_watchdog_now(Duration now);

  private:
    struct Screen {
        std::uint64_t flips = 0;
        Duration last{0};          // when `flips` last changed
        bool has_flipped = false;  // since the watchdog was fed
    };

    std::map<std::string, Screen> screens_;
    ShowState state_ = ShowState::no_panel;
    Duration fed_ = -period;
};

}  // namespace vitrine::player
