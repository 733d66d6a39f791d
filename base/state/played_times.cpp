#include "base/state/played_times.hpp"

#include "base/state/name_hash.hpp"
#include "base/state/path_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <stdexcept>

namespace vitrine {

namespace {

constexpr std::size_t check_digits = 8;
constexpr std::int64_t max_ns = 1'000'000'000LL * 60 * 60 * 24 * 400;  // of "undated", too

std::string check_of(const std::string& line) {
    return name_hash(line).substr(0, check_digits);
}

std::string line_of(std::string_view day, std::int64_t nanoseconds, const std::string& hex) {
    return fmt::format("{} {} {}", day, nanoseconds, hex);
}

}  // namespace

std::string played_day_name(std::optional<std::chrono::local_days> day) {
    if (!day) return played_undated;
    const std::chrono::year_month_day date(*day);
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

bool is_played_day(std::string_view name) {
    constexpr std::string_view form = "0000-00-00";
    const auto fits = [](char c, char of_form) { return of_form == '-' ? c == '-' : c >= '0' && c <= '9'; };
    return name == played_undated || std::ranges::equal(name, form, fits);
}

std::string played_text(const std::string& day, const PlayedTimes& times) {
    std::string text;
    for (const auto& [path, time] : times) {
        const std::string line = line_of(day, time.count(), "p" + to_hex(path));
        text += fmt::format("{} {}\n", line, check_of(line));
    }
    return text;
}

void merge_played(std::string_view text, std::string_view day, PlayedTimes& times) {
    std::istringstream lines{std::string(text)};
    std::string line;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string of_day, hex, check;
        std::int64_t nanoseconds = 0;
        if (!(words >> of_day >> nanoseconds >> hex >> check) || of_day != day) continue;
        if (check != check_of(line_of(of_day, nanoseconds, hex)) || nanoseconds > max_ns) continue;
        try {
            auto& known = times[from_hex(std::string_view(hex).substr(1))];
            known = std::max(known, std::chrono::nanoseconds(nanoseconds));
        } catch (const std::runtime_error&) {  // not of ours, though its checksum is right
            continue;
        }
    }
}

}  // namespace vitrine
