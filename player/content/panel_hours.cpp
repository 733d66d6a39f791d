#include "player/content/panel_hours.hpp"

#include "base/calendar/dates.hpp"
#include "base/settings/settings.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

PanelRules panel_rules(const Settings& settings) {
    return {.on = day_windows_named(settings.output.on).value_or(std::vector<DayWindow>{}),
            .dim = dim_windows_named(settings.output.dim).value_or(std::vector<DayWindow>{}),
            .awake = settings.output.awake,
            .holidays = dates_named(settings.show.holidays).value_or(Holidays{})};
}

void PanelHours::look(std::optional<std::chrono::local_seconds> local, std::chrono::nanoseconds now) {
    constexpr double change_a_second = 0.05;  // of the light
    const bool is_open =
        rules_.on.empty() || !local || find_window(rules_.on, *local, rules_.holidays) != nullptr;
    is_on_ = is_open || is_awake(now) || are_others_awake_;
    const DayWindow* dim = local ? find_window(rules_.dim, *local, rules_.holidays) : nullptr;
    const double wanted = dim == nullptr ? 1 : dim->share;
    const double seconds = std::chrono::duration<double>(now - looked_.value_or(now)).count();
    const double change = change_a_second * seconds;
    light_ = looked_ ? std::clamp(wanted, light_ - change, light_ + change) : wanted;
    looked_ = now;
}

void PanelHours::wake(std::chrono::nanoseconds now) {
    awake_until_ = now + rules_.awake;
}

std::string PanelHours::take_news() {
    if (is_on_ == std::exchange(is_told_on_, is_on_)) return {};
    return is_on_ ? "panels on" : "panels off, outside of output.on";
}

}  // namespace vitrine::player
