#pragma once

#include "base/calendar/day_windows.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

struct Settings;

}

namespace vitrine::player {

/// The operator's wishes for the panels.
struct PanelRules {
    std::vector<DayWindow> on;       // empty: always
    std::vector<DayWindow> dim;      // with the share of the light
    std::chrono::minutes awake{10};  // after a touch outside `on`
    Holidays holidays;               // count as Sundays
};

PanelRules panel_rules(const Settings& settings);

/// Tells if the panels are lit now, and how bright. Knows no clock.
class PanelHours {
  public:
    explicit PanelHours(PanelRules rules) : rules_(std::move(rules)) {}

    /// Replaces the rules. A touch that has lit the panels counts as long as it did.
    void set_rules(PanelRules rules) { rules_ = std::move(rules); }

    /// Call often.
    /// @param local  the local time; none: it is not known, and the panels are lit
    /// @param now    since the player's start; never goes back
    void look(std::optional<std::chrono::local_seconds> local, std::chrono::nanoseconds now);

    /// A visitor has touched a panel or a key: the panels are lit for a while.
    void wake(std::chrono::nanoseconds now);

    bool is_on() const { return is_on_; }

    /// True for a while after a touch, whatever the hours are.
    bool is_awake(std::chrono::nanoseconds now) const { return now < awake_until_; }

    /// Lights the panels for as long as a touch has lit those of another box of the wall.
    void set_others_awake(bool are_awake) { are_others_awake_ = are_awake; }

    /// The share of the light, (0, 1]. It changes slowly.
    double light() const { return light_; }

    /// News for the log since the last call: "off, outside of output.on". Empty: there are none.
    std::string take_news();

  private:
    PanelRules rules_;
    bool is_on_ = true;
    bool is_told_on_ = true;
    bool are_others_awake_ = false;
    double light_ = 1;
    std::optional<std::chrono::nanoseconds> looked_;
    std::chrono::nanoseconds awake_until_{0};
};

}  // namespace vitrine::player
