#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace vitrine::player {

/// What there is to say of a screen from across the room.
enum class ShowState {
    showing,     // pictures reach every display
    no_content,  // they do, but there is no file to show: the idle picture
    no_panel,    // there is no display, or no graphics card
    off,         // on purpose: another terminal or another program has the display
    no_flip,     // a display is there and takes no picture
};

/// "showing", "no content", "no panel", "off", "no flip".
const char* name_of(ShowState state);

/// What is seen of the screens at one moment.
struct Sight {
    struct Screen {
        std::string name;
        std::uint64_t flips = 0;  // pictures that have reached it so far
    };

    std::span<const Screen> screens;  // lent
    bool is_away = false;             // the display is left to others
    std::size_t items = 0;            // on the wall
};

/// Whether pictures reach the displays, and so whether systemd may be told that all is well: for each display
/// that is there a picture must have reached it since systemd was told last, or there must be none on
/// purpose. A main loop that stands still tells nothing at all. Knows no clock: time is passed in.
class Health {
  public:
    using Duration = std::chrono::nanoseconds;

    static constexpr Duration patience = std::chrono::seconds(5);  // with a display between two pictures
    static constexpr Duration period = std::chrono::seconds(1);    // between two words to systemd, at least

    /// To be called at every tick.
    void see(const Sight& sight, Duration now);

    ShowState state() const { return state_; }

    /// Since when a display has waited for a picture, at most; zero where there is none.
    Duration since_flip(Duration now) const;

    /// Whether systemd is to be told now; to be asked after each see(). True begins the next period.
    bool is_alive(Duration now);

  private:
    struct Screen {
        std::uint64_t flips = 0;
        Duration last{0};          // when they last changed
        bool has_flipped = false;  // since systemd was told
    };

    std::map<std::string, Screen> screens_;
    ShowState state_ = ShowState::no_panel;
    Duration told_ = -period;
};

}  // namespace vitrine::player
