#pragma once

#include "analyzer/status/file_state.hpp"
#include "base/hints/hints.hpp"
#include "base/state/visibility.hpp"

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::analyzer {

/// One file and what its operator may want to know of it.
struct StatusEntry {
    FileState file;
    Hints hints;
    std::string id;                         // record_id() of its path: names its thumbnail
    std::optional<FileVisibility> on_wall;  // none: the player does not run, or does not know the file yet
};

/// All that is told to those who drop files.
struct StatusReport {
    std::vector<StatusEntry> files;    // ordered by path
    std::vector<std::string> remarks;  // what is wrong with folders and files of hints
    bool is_online = true;             // the media folder is there
    bool is_player_running = true;
};

/// How a moment is written for people.
using ClockText = std::function<std::string(std::chrono::system_clock::time_point)>;

/// Files on the page at most; status.txt has all.
constexpr std::size_t most_on_page = 1000;

constexpr const char* player_is_off = "The player is not running.";

StateCounts counts_of(const StatusReport& report);

/// "ready, from 08:00 to 18:00. It is on the wall.", "waiting since 2026-11-21 14:05: half of the picture is
/// missing".
std::string in_words(const StatusEntry& entry, const ClockText& clock);

/// A line for the whole, one where the player is off, a line a remark, an empty one, then a line a file.
std::string status_text(const StatusReport& report, const ClockText& clock);

/// The files on the page: first those that are not ready, at most half of it, then the ready ones, those that
/// were found out last first.
std::vector<StatusEntry> on_page(const StatusReport& report);

/// @param files       of on_page()
/// @param thumbnails  ids of those that lie in thumbnails/
/// @param has_wall    wall.jpg lies beside
std::string status_page(const StatusReport& report, const std::vector<StatusEntry>& files,
                        const std::set<std::string>& thumbnails, bool has_wall, const ClockText& clock);

/// STATE/status.json (docs/catalogue.md).
std::string status_json(const StatusReport& report);

}  // namespace vitrine::analyzer
