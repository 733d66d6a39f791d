#include "base/hints/notice.hpp"

#include "base/calendar/dates.hpp"
#include "base/state/path_text.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace vitrine {

namespace {

constexpr std::string_view mark = "!now";
constexpr std::string_view dividers = " _";

/// "20min"; none: another text, no time, or more than a day.
std::optional<std::chrono::seconds> length_named(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, std::chrono::seconds>, 3> units{
        {{"min", std::chrono::minutes(1)}, {"h", std::chrono::hours(1)}, {"s", std::chrono::seconds(1)}}};
    constexpr std::size_t max_digits = 5;
    const std::string word = lower_case(text);
    for (const auto& [unit, length] : units) {
        if (!word.ends_with(unit)) continue;
        const std::size_t digits = word.size() - unit.size();
        const auto count = digits > max_digits
                               ? std::nullopt
                               : digits_named(std::string_view(word).substr(0, digits), digits);
        if (digits == 0 || !count || *count < 1 || *count * length > std::chrono::hours(24))
            return std::nullopt;
        return *count * length;
    }
    return std::nullopt;
}

}  // namespace

std::optional<Notice> notice_named(std::string_view path) {
    const std::size_t slash = path.find('/');
    const std::string_view entry = path.substr(0, slash);
    if (!entry.starts_with('!') || lower_case(entry.substr(0, mark.size())) != mark) return std::nullopt;
    std::string_view rest = entry;
    if (slash == std::string_view::npos) rest = rest.substr(0, rest.rfind('.'));  // without a file's ending
    rest.remove_prefix(std::min(mark.size(), rest.size()));
    if (!rest.empty() && dividers.find(rest.front()) == std::string_view::npos) return std::nullopt;
    rest.remove_prefix(std::min(rest.find_first_not_of(dividers), rest.size()));
    return Notice{.entry = std::string(entry),
                  .length = length_named(rest.substr(0, rest.find_first_of(dividers)))};
}

}  // namespace vitrine
