#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace vitrine::player {

/// The state of the screens, as seen from across the room.
enum class ShowState {
    showing,     // pictures reach every display
    no_content,  // pictures reach them, but no file can be shown: the idle picture
    no_panel,    // there is no display, or no graphics card
    off,         // another terminal or another program has the display, on purpose
    no_flip,     // a display is there but takes no picture
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
    bool is_away = false;             // the display is left to another program
    std::size_t items = 0;            // items on the wall
};

/// Decides if systemd's watchdog may be fed. Since the last feeding a picture must have reached each display,
/// or there must be no display on purpose. A main loop that stands still feeds nothing. Knows no clock: the
/// time is passed in.
class Health {
  public:
    using Duration = std::chrono::nanoseconds;

    static constexpr Duration patience = std::chrono::seconds(5);  // longest time between two pictures
    static constexpr Duration period = std::chrono::seconds(1);    // shortest time between two feedings

    /// Call at every tick.
    void set_screens(const ScreenState& screens, Duration now);

    ShowState state() const { return state_; }

    /// The longest time that a display has waited for a picture; zero without a display.
    Duration since_flip(Duration now) const;

    /// Call after each set_screens(). @return  true: feed the watchdog now; the next period starts
    bool feed_watchdog_now(Duration now);

  private:
    struct Screen {
        std::uint64_t flips = 0;
        Duration last{0};          // time at which `flips` last changed
        bool has_flipped = false;  // a picture came since the last feeding
    };

    std::map<std::string, Screen> screens_;
    ShowState state_ = ShowState::no_panel;
    Duration fed_ = -period;
};

}  // namespace vitrine::player
