#pragma once

#include "analyzer/status/file_state.hpp"
#include "base/hints/hints.hpp"
#include "base/hints/keyframe_choice.hpp"
#include "base/state/visibility.hpp"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// One file as its operator sees it.
struct StatusEntry {
    FileState file;
    Hints hints;
    KeyframeChoice keyframes{};             // of its tapestry
    std::string id;                         // record_id() of its path: names its thumbnail
    std::optional<FileVisibility> on_wall;  // none: the player does not run, or does not know the file yet
};

/// The state of all files, for those who drop them.
struct StatusReport {
    std::vector<StatusEntry> files;    // ordered by path
    std::vector<std::string> remarks;  // mistakes in files of hints, folders that cannot be read
    std::vector<std::string> inbox{};  // files that are not shown until somebody moves them
    bool is_online = true;             // the media folder is there
    bool is_player_running = true;
};

constexpr const char* player_is_off = "The player is not running.";
constexpr const char* what_inbox_is = "In the inbox, not shown until somebody moves it out";

/// STATE/status.json (docs/catalogue.md).
std::string status_json(const StatusReport& report);

/// Writes a moment for people.
using ClockText = std::function<std::string(std::chrono::system_clock::time_point)>;

}  // namespace vitrine::analyzer
