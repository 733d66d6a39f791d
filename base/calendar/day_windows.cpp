#include "base/calendar/day_windows.hpp"

#include "base/calendar/dates.hpp"

#include <algorithm>

namespace vitrine {

namespace {

/// The words of a text, divided by spaces.
std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t begin = 0; (begin = text.find_first_not_of(' ', begin)) != std::string_view::npos;) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        words.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

/// 0.4 for "40%"; none: another text.
std::optional<double> share_named(std::string_view text) {
    if (text.size() < 2 || text.size() > 4 || text.back() != '%') return std::nullopt;
    text.remove_suffix(1);
    const auto percent = digits_named(text, text.size());
    if (!percent || *percent < 1 || *percent > 100) return std::nullopt;
    return *percent / 100.0;
}

/// A window of days, hours or both.
std::optional<DayWindow> window_named(std::vector<std::string_view> words, bool has_share) {
    DayWindow window;
    if (has_share) {
        const auto share = words.empty() ? std::nullopt : share_named(words.back());
        if (!share) return std::nullopt;
        window.share = *share;
        words.pop_back();
    }
    if (!words.empty()) window.hours = hours_named(words.back());
    if (window.hours) words.pop_back();
    if (!words.empty()) window.weekdays = weekdays_named(words.back());
    if (window.weekdays) words.pop_back();
    if (!words.empty() || (!window.weekdays && !window.hours)) return std::nullopt;
    return window;
}

std::optional<std::vector<DayWindow>> windows_named(std::string_view text, bool has_share) {
    std::vector<DayWindow> windows;
    while (!words_of(text).empty()) {
        const std::size_t end = std::min(text.find(", "), text.size());
        const auto window = window_named(words_of(text.substr(0, end)), has_share);
        if (!window) return std::nullopt;
        windows.push_back(*window);
        text.remove_prefix(std::min(text.size(), end + 2));
    }
    return windows;
}

}  // namespace

std::optional<std::vector<DayWindow>> day_windows_named(std::string_view text) {
    return windows_named(text, false);
}

std::optional<std::vector<DayWindow>> dim_windows_named(std::string_view text) {
    return windows_named(text, true);
}

const DayWindow* find_window(const std::vector<DayWindow>& windows, std::chrono::local_seconds now,
                             const Holidays& holidays) {
    const auto found = std::ranges::find_if(windows, [&](const DayWindow& window) {
        const auto day = opening_day(window.hours, now);
        return day && (!window.weekdays || is_on(*window.weekdays, *day, holidays));
    });
    return found == windows.end() ? nullptr : &*found;
}

}  // namespace vitrine
