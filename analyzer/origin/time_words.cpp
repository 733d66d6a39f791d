#include "analyzer/origin/time_words.hpp"

#include "base/calendar/dates.hpp"

#include <string>

namespace vitrine::analyzer {

namespace {

constexpr std::size_t date_length = 10;
constexpr std::size_t time_length = 19;

}  // namespace

std::optional<std::chrono::local_days> day_named(std::string_view text) {
    if (text.size() < date_length) return std::nullopt;
    std::string date(text.substr(0, date_length));
    if (date[4] == ':' && date[7] == ':') date[4] = date[7] = '-';
    return date_named(date);
}

std::optional<std::chrono::local_seconds> civil_time_named(std::string_view text) {
    const auto day = day_named(text);
    if (!day || text.size() < time_length || (text[10] != ' ' && text[10] != 'T')) return std::nullopt;
    if (text[13] != ':' || text[16] != ':') return std::nullopt;
    const auto hours = digits_named(text.substr(11, 2), 2);
    const auto minutes = digits_named(text.substr(14, 2), 2);
    const auto seconds = digits_named(text.substr(17, 2), 2);
    if (!hours || !minutes || !seconds || *hours > 23 || *minutes > 59 || *seconds > 60) return std::nullopt;
    return *day + std::chrono::hours(*hours) + std::chrono::minutes(*minutes) +
           std::chrono::seconds(*seconds);
}

std::optional<std::chrono::minutes> zone_named(std::string_view text) {
    constexpr int max_hours = 14;
    if (text == "Z") return std::chrono::minutes(0);
    if (text.size() < 5 || (text[0] != '+' && text[0] != '-')) return std::nullopt;
    const auto hours = digits_named(text.substr(1, 2), 2);
    const auto minutes = digits_named(text.substr(text[3] == ':' ? 4 : 3), 2);
    if (!hours || !minutes || *hours > max_hours || *minutes > 59) return std::nullopt;
    const std::chrono::minutes zone(*hours * 60 + *minutes);
    return text[0] == '-' ? -zone : zone;
}

}  // namespace vitrine::analyzer
