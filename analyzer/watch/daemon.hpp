#pragma once

#include "analyzer/status/status_writer.hpp"
#include "analyzer/store/store.hpp"
#include "analyzer/store/store_place.hpp"
#include "analyzer/watch/analysis_outcome.hpp"
#include "analyzer/watch/child_process.hpp"
#include "analyzer/watch/file_states.hpp"
#include "analyzer/watch/film_growth.hpp"
#include "analyzer/watch/folder_follower.hpp"
#include "analyzer/watch/hint_files.hpp"
#include "analyzer/watch/liveness.hpp"
#include "analyzer/watch/media_folder.hpp"
#include "analyzer/watch/missing_thumbnails.hpp"
#include "analyzer/watch/schedule.hpp"
#include "analyzer/watch/weaver.hpp"
#include "base/state/catalogue.hpp"
#include "base/system/event_loop.hpp"
#include "base/system/unique_fd.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Everything that `watch` can be told.
struct WatchOptions {
    std::filesystem::path root;
    std::filesystem::path catalogue;
    std::filesystem::path store;
    std::filesystem::path state;  // hints.json, status.json, thumbnails/ and wall.jpg
    std::vector<std::string>
        thumbnail_child;        // likewise of one thumbnail that the status page lacks; may be empty
    std::string status_folder;  // in the root, for its operators; empty: none
    StoreBounds bounds{.max_bytes = 0, .least_free = least_free_bytes};
    std::vector<std::string> child;  // the command that writes one record; the file's path is appended
    std::vector<std::string> weave;  // the command that weaves a tapestry; see WeaveOptions
    StoreBounds tapestries{.max_bytes = 0, .least_free = least_free_bytes};
    ChildLimits limits;                // the deadline is that of an empty file
    double deadline_per_mebibyte = 0;  // seconds
    Pace pace;
    std::chrono::milliseconds rescan{60'000};
    bool is_once = false;  // ends the loop as soon as the catalogue is up to date
};

/// Keeps the catalogue equal to the media folder: follows the folder, has each file analysed in a child of
/// its own, writes what the children say. Runs in the loop for as long as it exists; logs.
class Daemon {
  public:
    /// Reads the catalogue and the folder.
    /// @throws std::system_error where the catalogue cannot be written or is written by another process
    /// (EBUSY)
    Daemon(EventLoop& loop, const WatchOptions& options);
    Daemon(const Daemon&) = delete;
    Daemon& operator=(const Daemon&) = delete;
    ~Daemon();

    /// Whether the media folder was there when last looked for.
    bool is_online() const { return follower_.is_online(); }

    /// Whether the folder was there and every record is on the disk.
    bool is_up_to_date() const { return is_online() && unsaved_.empty() && unremoved_.empty(); }

    std::string status() const;

    /// Where each file of the folder stands now, ordered by path.
    std::vector<FileState> files() const;

  private:
    void load_catalogue();
    void rescan();
    void read_hints();
    bool is_to_be_heard(const std::string& path) const;
    void want_sounds();
    StatusReport report() const;
    std::filesystem::path thumbnail(const std::string& path) const;
    void advance();
    void wake_at(std::optional<Schedule::Time> time, Schedule::Time begin);
    void perform(const Action& action);
    void start(const Action& action);
    void finish(const std::string& path, const FileFacts& facts, const ChildResult& result,
                const ChildLimits& limits);
    void grow(const std::string& path, const FileFacts& facts, const std::string& line);
    void store_growth();
    void answer(Outcome outcome);
    void move(const Action& action);
    std::optional<MediaRecord> stored(const std::string& path) const;
    void store(MediaRecord record);
    void remove_record(const std::string& path);
    void store_again();
    void follow_blame();
    void make_room();
    void tell(const MediaRecord& record);
    void tell_systemd();
    void get_on();
    void feed_watchdog();
    void make_thumbnails();

    EventLoop& loop_;  // outlives this
    WatchOptions options_;
    MediaFolder folder_;
    Catalogue catalogue_;
    Store store_;
    UniqueFd lock_;
    Schedule schedule_;
    FolderFollower follower_;
    HintFiles hint_files_;
    Weaver weaver_;
    std::set<std::string>
        heard_;  // files that are to be heard, of which it was seen whether their sound is kept
    std::map<std::string, std::unique_ptr<ChildProcess>> children_;
    std::map<std::string, Schedule::Time> reading_;  // the files of the children, and since when
    GrowingRecords growing_;
    FileStates states_;
    bool is_growth_resting_ = false;              // parts were written a moment ago
    std::map<std::string, MediaRecord> unsaved_;  // the disk was full: stored again at the next rescan
    std::set<std::string> unremoved_;             // paths of records, likewise
    bool is_lack_told_ = false;                   // of room on the disk
    std::set<std::string> told_waiting_;          // files whose waiting was told: once is enough
    std::vector<std::string> remarks_;            // of the last rescan: each is told once
    std::size_t analysed_ = 0;
    StatusWriter status_;
    MissingThumbnails thumbnails_;
    Pulse pulse_;
    std::optional<Schedule::Time> fed_;  // systemd was told that all is well
    std::string missed_;                 // why it was not told
    bool is_telling_ = false;            // systemd is told of the state in a moment
    EventLoop::Source events_, wake_, rescan_, growth_, hints_, watchdog_, telling_;
};

}  // namespace vitrine::analyzer
