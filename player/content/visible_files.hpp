#pragma once

#include "base/state/visibility.hpp"
#include "player/content/catalogue_follower.hpp"
#include "player/content/crash_note.hpp"
#include "player/content/hours_follower.hpp"
#include "player/content/judged_files.hpp"
#include "player/content/notices.hpp"
#include "player/content/visible_note.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

class Rehearsal;

/// A folder that at least one screen shows.
struct ShownFolder {
    std::string folder;               // the output's folder, below the media folder; empty: all files
    std::string opened;               // the only folder that a visitor looks into; empty: all
    std::set<std::string> avoided{};  // paths of the files that the screen leaves out for a while

    bool operator==(const ShownFolder&) const = default;
};

/// The content of all screens at one moment.
struct WallContent {
    std::vector<ShownFolder> folders;  // empty: there is no screen
    std::set<std::string> files;       // paths of the files that are shown
    std::set<std::string> open;        // paths of the files that are read or played
    bool is_off = false;               // the displays are off at this hour, or another program has them

    bool operator==(const WallContent&) const = default;
};

/// The one list of the files that may be on the wall, with the reason for each other file. It follows the
/// catalogue, the hours, the crashes of the player and the files that vitrinectl took off; judge_file() has a
/// line for each filter but the notices. Only files that changed are judged anew. It keeps STATE/visible.json
/// up to date. Logs.
class VisibleFiles {
  public:
    using Time = CrashNote::Time;

    /// @param state      the state directory
    /// @param rehearsal  outlives this; none: there is no rehearsal
    /// @param on_change  called when other files may be shown; the first time by this constructor
    VisibleFiles(EventLoop& loop, const std::filesystem::path& state, const ShowDays& days,
                 const Rehearsal* rehearsal, std::function<void()> on_change);

    /// The files that may be shown, ordered by path.
    const RecordList& records() const { return judged_.visible(); }

    /// The hints for showing the files.
    const ShowHints& hints() const { return hints_; }

    /// The number of files in each state of the analyzer.
    const std::map<MediaState, std::size_t>& counts() const { return follower_.counts(); }

    /// The number of ready files, with those that a filter keeps off the wall.
    std::size_t count_ready() const { return ready_.size(); }

    /// The number of judgements so far.
    std::size_t judgements() const { return judged_.judgements(); }

    /// All files of which the analyzer has written a record, visible or not.
    const RecordList& catalogue() const { return follower_.records(); }

    /// The first filter that keeps the file off the wall.
    FileVisibility judge(const MediaRecord& file) const;

    /// Judges all files again: the rehearsal has changed.
    void apply_filters();

    /// Call at every tick. Looks once a second, because hours begin and end on the second.
    /// @param time     since the player's start
    /// @param content  gives the present content of the screens
    void look(std::chrono::nanoseconds time, Time now, const std::function<WallContent()>& content);

    /// Takes these files off the wall, each until it changes; others may be there again.
    void set_dismissed(const std::set<std::string>& paths);

    /// Ends the quarantine of a file, here and in the analyzer, and all suspicion of it.
    /// @param path  "": all files
    /// @throws std::system_error if the state directory cannot be written
    void acquit(const std::string& path);

    /// Paths of the dismissed files.
    std::vector<std::string> dismissed() const;

    /// Call before the player opens a file of the media folder, and when a file made its reader crash.
    void note_file(const std::string& path, FileNews news, Time now);

    /// Call when the run ends in order.
    void end_run();

  private:
    void follow_catalogue(const CatalogueChange& change, const RecordList& records);
    void judge_again(std::optional<std::set<std::string>> paths);
    void tell_change(bool is_other);
    void set_content(WallContent content);
    FileVisibility judge_file(const MediaRecord& file) const;

    const Rehearsal* rehearsal_;
    std::function<void()> on_change_;
    CrashNote crash_note_;
    Notices notices_;
    HoursFollower hours_;
    ShowHints hints_;  // with the groups
    std::map<std::string, RecordList::Record> dismissed_;
    WallContent content_;
    std::chrono::nanoseconds next_look_{0};
    RecordList records_;  // the whole catalogue
    RecordList ready_;    // those with shots
    JudgedFiles judged_;
    std::string logged_;  // the last logged line of tell_change()
    VisibleNote note_;
    CatalogueFollower follower_;  // last: it calls back from its constructor
};

}  // namespace vitrine::player
