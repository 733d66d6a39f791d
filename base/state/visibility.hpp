#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

// The player's answer to "why is this file not on the wall?". The player writes it to STATE/visible.json; the
// analyzer reads it for its status page: docs/catalogue.md.

/// The first filter that keeps a file off the wall, in the order of the filters. At the end: no filter does.
enum class Visibility {
    not_analysed,    // its record has no shot that could be shown yet
    unsupported,     // the analyzer has found nothing that can be shown
    not_rehearsed,   // the rehearsal says that it is absent
    held_back,       // it made the player crash, or is a suspect
    dismissed,       // vitrinectl took it off the wall
    no_clock,        // it has days or hours, but the clock is not plausible yet
    out_of_hours,    // it has days or hours, and now is outside
    notice_over,     // its notice has had its time
    covered,         // a notice covers the walls
    other_folder,    // no connected screen shows its folder
    screens_off,     // no display shows anything: it is off at this hour, or another program has it
    closed_folder,   // a visitor looks into another folder
    avoided,         // left out for a minute: it could not be played, or a visitor flicked it away
    in_group,        // another file hangs that is one with it, such as a frame of the same burst
    waits_for_turn,  // it may be shown, but other files are shown now
    on_wall          // it is shown now
};

struct FileVisibility {
    std::string path;  // relative to the media folder, any bytes
    Visibility visibility = Visibility::waits_for_turn;
    std::string detail;  // facts about this file from the filter, such as its hours; may be empty

    bool operator==(const FileVisibility&) const = default;
};

/// True: no filter keeps the file off the wall.
bool may_be_shown(Visibility visibility);

/// The filter's word in STATE/visible.json and in the player's log: "out_of_hours".
const char* name_of(Visibility visibility);

/// Words for a count of files in a log line: "out of hours", "held back after a crash".
const char* in_short(Visibility visibility);

/// A sentence for people: "It is out of its hours: it is shown from 20:00 to 21:00."
std::string sentence(const FileVisibility& file);

/// The text of STATE/visible.json.
std::string visible_json(std::span<const FileVisibility> files);

constexpr const char* visible_file =
    "visible.json";  // below the state directory; written by the player alone

/// The player writes the file, or sets its time, at least this often.
constexpr std::chrono::seconds visible_heartbeat{10};

/// An older file was left by a player that no longer runs.
constexpr std::chrono::seconds max_visible_age{30};

/// The player's files, by path.
using VisibleByPath = std::map<std::string, FileVisibility>;

/// Reads STATE/visible.json again whenever it has changed.
class VisibleReader {
  public:
    explicit VisibleReader(const std::filesystem::path& state) : file_(state / visible_file) {}

    /// Call now and then.
    /// @return true: is_player_running() or files() has changed since the last call
    bool look(std::filesystem::file_time_type now);

    bool is_player_running() const { return is_running_; }

    /// Empty: the player does not run, or its file cannot be read.
    const VisibleByPath& files() const { return files_; }

  private:
    std::filesystem::path file_;
    std::optional<std::filesystem::file_time_type> written_;  // time of writing of the file that was read
    std::string text_;
    bool is_running_ = false;
    VisibleByPath files_;
};

/// @throws std::runtime_error if the text has another form
VisibleByPath visible_from_json(std::string_view text);

}  // namespace vitrine
