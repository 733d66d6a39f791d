#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

// Proof of play: how long each file was seen on a day. The player counts in STATE/played/; the analyzer
// copies it to the status folder: docs/catalogue.md.

/// Maps a file's path to the time for which it was seen; files beyond max_played_files share the path "".
using PlayedTimes = std::map<std::string, std::chrono::nanoseconds>;

constexpr const char* played_folder = "played";    // below the state directory; written by the player alone
constexpr const char* played_now = "now";          // in it: what the files of the days do not have yet
constexpr const char* played_undated = "undated";  // in it, in place of a day: the clock was not plausible
constexpr std::size_t max_played_days = 400;       // kept
constexpr std::size_t max_played_files = 20000;    // a day

/// The name of a day's file: "2026-12-24". @param day  none: the clock was not plausible
std::string played_day_name(std::optional<std::chrono::local_days> day);

/// True for "2026-12-24" and "undated".
bool is_played_day(std::string_view name);

/// A line a file, which ends with a checksum. @param day  the name of the day
std::string played_text(const std::string& day, const PlayedTimes& times);

/// Takes the times of a day from a text of played_text(), where they are longer than those known. Damaged
/// lines and those of other days do not count.
void merge_played(std::string_view text, std::string_view day, PlayedTimes& times);

}  // namespace vitrine
