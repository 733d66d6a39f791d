#pragma once

#include "base/state/visibility.hpp"
#include "player/control/health.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

struct ScreenReport {
    std::string name;  // the output's name
    int width = 0;     // px
    int height = 0;
    double refresh = 0;  // pictures a second; 0: unknown
    std::uint64_t flips = 0;
};

struct CellReport {
    int slot = 0;
    std::string path;
    int shot = 0;
    bool is_pinned = false;
};

struct SourceReport {
    std::string path;
    std::string tier;        // "photo"; a film's share of pictures: "all", "reference", "key", "still"
    bool is_stored = false;  // played from the store, not from the media folder
    std::uint64_t late = 0;  // late pictures so far
};

/// A wall of several boxes, as this box knows it.
struct WallReport {
    struct Box {
        std::string name;
        bool leads = false;
        bool is_gone = false;
        std::int64_t run = 0;  // of the leader, and the number of its act that is shown; 0: none yet
        std::uint64_t generation = 0;
        bool has_right_clock = false;
        std::chrono::microseconds difference{0};  // of its time from its system's clock
        std::vector<std::string> lacking = {};    // paths of shots that it has not got
        std::string fetch_fault = {};  // why it could not fetch files the last time; empty: it could
    };

    std::string name;
    std::string own;   // the name of this box
    std::string link;  // what vitrine-link says
    std::vector<Box> boxes;
};

/// Says in words what a box of a wall does: "follows, in step, its clock 40 us off".
/// @param leader  what the leader shows; nullptr: no leader is known
std::string in_words(const WallReport::Box& box, const WallReport::Box* leader);

/// The facts about the player at one moment, for reports.
struct PlayerReport {
    ShowState state = ShowState::no_panel;
    std::string display;  // card, modes and renderer in words, or the reason why there is no display
    std::vector<ScreenReport> screens;
    std::vector<std::string> faults;  // what the settings say of outputs and cannot be; a sentence each
    std::vector<CellReport> cells;
    std::vector<SourceReport> sources;
    std::size_t files = 0;                    // number of ready files
    std::size_t queue = 0;                    // sources without a picture yet
    std::int64_t pictures = 0;                // frames shown since the start
    std::int64_t late = 0;                    // frames that were left out because they came too late
    std::uint64_t film_late = 0;              // pictures of films that came too late
    double rate = 0;                          // frames a second that reach each display
    std::chrono::milliseconds since_flip{0};  // the longest time that a display has waited
    bool is_paused = false;
    std::vector<std::string> pinned;     // files
    std::vector<std::string> dismissed;  // files
};

/// The facts about one file of the media folder.
struct FileReport {
    std::string path;                 // relative to the media folder; without a record, the name as given
    std::string state;                // its record's state; "unknown": there is no record
    std::vector<std::string> places;  // without a record: where the file would be, absolute
    std::string reason;
    std::string kind;
    int width = 0;  // px
    int height = 0;
    std::size_t shots = 0;
    FileVisibility visibility;  // for a file with a record
    std::vector<int> slots;     // its slots on the wall
    bool is_pinned = false;
    bool is_dismissed = false;
};

/// One line for `systemctl status`.
std::string one_line(const PlayerReport& report);

/// For programs, with the analyzer's own word where it has left one.
/// @param analyzer  AnalyzerWord::summary
/// @param wall      none: the wall is this box's alone
std::string to_json(const PlayerReport& report, const std::string& analyzer,
                    const std::optional<WallReport>& wall = {});

/// For programs, with a sentence for people and the analyzer's own word where it has left one.
/// @param analyzer  AnalyzerWord::entry() of the file
std::string to_json(const FileReport& report, const std::string& analyzer);

/// The text that a node exporter reads from a file (the Prometheus text format).
/// @param degrees  temperature of the hottest part of the machine, Celsius
/// @param states   the number of files in each state of the analyzer
std::string to_metrics(const PlayerReport& report, std::optional<double> degrees,
                       const std::vector<std::pair<std::string, std::size_t>>& states);

}  // namespace vitrine::player
