#pragma once

#include "base/hints/folder_hints.hpp"
#include "player/scene/files/show_files.hpp"

#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace vitrine::player {

/// Decides which files may be shown now, by the periods and hours in the hints of names and folders. Knows no
/// clock: the time is passed in.
class OpeningHours {
  public:
    /// @param holidays  count as Sundays
    explicit OpeningHours(Holidays holidays = {}) : holidays_(std::move(holidays)) {}

    /// Reads the hints of files that came since the last call.
    void set_files(const RecordList& files);

    /// Reads the hints of all files again.
    void set_folders(FolderHints folders);

    /// @param now   local time; none: unknown
    /// @return  true: other files may be shown than at the last call, or with other hints
    bool advance(std::optional<std::chrono::local_seconds> now);

    /// Removes and returns the paths of the files that opened, closed or got other hints since the last call,
    /// and of those with hours if the time has become known or unknown.
    std::set<std::string> take_changed();

    bool is_open(const std::string& path) const { return !closed_.contains(path); }

    /// The hints of the files that were set.
    const ShowHints& hints() const { return hints_; }

    /// True: a file has days or hours.
    bool has_hours() const { return !scheduled_.empty(); }

  private:
    void set_hints(const std::string& path, const Hints& hints, ShowHints::Changes& changes);

    Holidays holidays_;
    FolderHints folders_;
    RecordList files_;
    ShowHints hints_;
    std::map<std::string, Hints> scheduled_;  // the files with days or hours
    std::set<std::string> closed_;            // paths of the files that may not be shown now
    std::set<std::string> changed_;
    bool has_time_ = false;
    bool is_new_ = true;  // files or folders have changed since the last advance()
};

}  // namespace vitrine::player
