#pragma once

#include "analyzer/watch/media_folder.hpp"
#include "analyzer/watch/schedule.hpp"
#include "base/system/directory_watch.hpp"

#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

/// Tells the schedule which files are in the media folder: events of the kernel at once, all other changes
/// whenever the whole folder is read. A folder that is not there, or cannot be read, loses no file.
class FolderFollower {
  public:
    /// @param schedule  outlives this
    FolderFollower(MediaFolder folder, Schedule& schedule)
        : folder_(std::move(folder)), schedule_(schedule) {}

    const MediaFolder& folder() const { return folder_; }

    /// Becomes readable when there are events.
    int fd() const { return watch_.fd(); }

    /// True where the folder was there at the last look.
    bool is_online() const { return is_online_; }

    /// Reads the whole folder.
    /// @param attend  called with each file and folder, for that may take minutes
    void rescan(Schedule::Time now, const MediaFolder::Attend& attend = {});

    /// Parts of the folder that the last rescan could not read, in plain words.
    const std::vector<std::string>& remarks() const { return remarks_; }

    /// The files that lay in the inbox at the last rescan, in order.
    const std::vector<std::string>& inbox() const { return inbox_; }

    /// Something failed while the folder was followed: that is a remark until the next rescan.
    /// @return whether it was none before
    bool note_failure(const std::string& failure);

    /// Follows the kernel's events. @return whether the folder must be read as a whole
    bool read_events(Schedule::Time now);

    /// The files that choose keyframes, see is_keyframe_file(). One of them may have gone by now.
    const std::set<std::string>& sidecars() const { return sidecars_; }

    /// @return true where a file of hints or of keyframes or a folder came, went or changed since the last
    /// call
    bool take_hint_news() { return std::exchange(has_hint_news_, false); }

    /// Looks at single files.
    void look_at(std::span<const std::string> paths, Schedule::Time now);

  private:
    /// Paths by the change that the kernel has reported.
    struct Changes {
        std::set<std::string> files;    // written, changed or removed
        std::set<std::string> closed;   // files that nobody writes any more
        std::set<std::string> added;    // folders
        std::set<std::string> removed;  // folders
        bool is_lost = false;           // events are missing, or the root is gone
    };

    Changes read_changes();
    void watch_folder(const std::string& folder);
    void list_below(const std::string& folder, Schedule::Time now);
    void compare(const MediaFolder::Listing& listing, const std::string& folder, Schedule::Time now);
    void see_file(const MediaFolder::File& file, Schedule::Time now, bool is_closed = false);
    void look_at_changed(const Changes& changes, Schedule::Time now);
    void lose_missing(const std::vector<std::string>& missing, Schedule::Time now);
    bool is_suspiciously_empty(const MediaFolder::Listing& listing) const;

    MediaFolder folder_;
    Schedule& schedule_;
    DirectoryWatch watch_;
    std::size_t unwatched_ = 0;  // folders that the kernel refused to watch in this rescan
    int unwatched_because_ = 0;  // errno of the last of them
    std::vector<std::string> remarks_;
    std::vector<std::string> inbox_;
    bool is_online_ = false;
    bool has_hint_news_ = false;
    std::set<std::string> sidecars_;
    bool is_remote_ = false;
    bool has_seen_files_ = false;          // since the start of this process
    std::optional<std::uint64_t> device_;  // where files were last seen
};

}  // namespace vitrine::analyzer
