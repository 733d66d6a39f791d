#pragma once

#include "base/hints/folder_hints.hpp"
#include "player/scene/show_files.hpp"

#include <chrono>
#include <cstddef>
#include <optional>
#include <set>
#include <string>

namespace vitrine::player {

/// Decides which files may be shown now, by the periods and hours in the hints of names and folders. Knows no
/// clock: the time is passed in.
class OpeningHours {
  public:
    void set_files(const RecordList& files);
    void set_folders(FolderHints folders);

    /// @param now   local time; none: unknown
    /// @return  true: other files may be shown than at the last call, or with other hints
    bool advance(std::optional<std::chrono::local_seconds> now);

    bool is_open(const std::string& path) const { return !closed_.contains(path); }

    /// The hints of the files that were set.
    const ShowHints& hints() const { return hints_; }

    /// True: a file has a period or hours.
    bool has_hours() const { return has_hours_; }

    std::size_t count_closed() const { return closed_.size(); }

  private:
    void read_hints();

    FolderHints folders_;
    RecordList files_;
    ShowHints hints_;
    std::set<std::string> closed_;  // paths of the files that may not be shown now
    bool has_hours_ = false;
    bool is_new_ = true;  // files or folders have changed since the last advance()
};

}  // namespace vitrine::player
