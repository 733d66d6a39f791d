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

/// Tells the schedule what is in the media folder: what the kernel reports at once, everything else whenever
/// the folder is read as a whole. A folder that is not there, or cannot be read, loses no file.
class FolderFollower {
  public:
    FolderFollower(const MediaFolder& folder, Schedule& schedule) : folder_(folder), schedule_(schedule) {}

    /// Becomes readable when there are events.
    int fd() const { return watch_.fd(); }

    /// Whether the folder was there when last looked for.
    bool is_online() const { return is_online_; }

    /// Reads the whole folder. @return what could not be read, in plain words
    /// @param attend  called with each file and folder, for that may take minutes
    std::vector<std::string> rescan(Schedule::Time now, const MediaFolder::Attend& attend = {});

    /// Follows what the kernel has reported. @return whether the folder must be read as a whole
    bool read_events(Schedule::Time now);

    /// Whether a `.vitrine.toml` or a folder came, went or changed since the last call.
    bool take_hint_news() { return std::exchange(has_hint_news_, false); }

    /// Looks at single files.
    void look_at(std::span<const std::string> paths, Schedule::Time now);

  private:
    void watch(const std::string& folder);
    void list_below(const std::string& folder, Schedule::Time now);
    void compare(const MediaFolder::Listing& listing, const std::string& folder, Schedule::Time now);
    void saw(const MediaFolder::File& file, Schedule::Time now, bool is_closed = false);
    void look_at(std::span<const std::string> paths, const std::set<std::string>& closed, Schedule::Time now);
    std::string relative(const std::filesystem::path& directory) const;
    bool is_unmounted(const MediaFolder::Listing& listing) const;
    bool is_suspiciously_empty(const MediaFolder::Listing& listing) const;

    const MediaFolder& folder_;  // outlives this
    Schedule& schedule_;         // outlives this
    DirectoryWatch watch_;
    std::size_t unwatched_ = 0;  // folders that the kernel refused to watch in this rescan
    bool is_online_ = false;
    bool has_hint_news_ = false;
    bool is_remote_ = false;
    bool has_seen_files_ = false;          // in this run
    std::optional<std::uint64_t> device_;  // where files were last seen
};

}  // namespace vitrine::analyzer
