#pragma once

#include "analyzer/status/status_writer.hpp"
#include "analyzer/watch/analyses.hpp"
#include "analyzer/watch/file_book.hpp"
#include "analyzer/watch/folder_follower.hpp"
#include "analyzer/watch/hint_files.hpp"
#include "analyzer/watch/liveness.hpp"
#include "analyzer/watch/missing_pictures.hpp"
#include "analyzer/watch/schedule.hpp"
#include "analyzer/watch/watch_options.hpp"
#include "analyzer/watch/weaver.hpp"
#include "base/system/event_loop.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Keeps the catalogue equal to the media folder: follows the folder, has each file analysed in a child
/// process, stores the records that the children print. Runs in the loop for as long as it exists; logs.
class Daemon {
  public:
    /// Reads the catalogue and the folder.
    /// @throws std::system_error where the catalogue cannot be written, or another process writes it (EBUSY)
    Daemon(EventLoop& loop, const WatchOptions& options);
    Daemon(const Daemon&) = delete;
    Daemon& operator=(const Daemon&) = delete;
    ~Daemon() = default;

    /// True where the media folder was there at the last look.
    bool is_online() const { return follower_.is_online(); }

    /// True where the folder is there and every record is on the disk.
    bool is_up_to_date() const;

    /// The text for `systemctl status`: the number of files in each state, the files that are analysed now,
    /// what is wrong.
    std::string status() const;

    /// The state of each file in the folder, ordered by path.
    std::vector<FileState> files() const;

  private:
    void attempt(const std::function<void()>& work);
    void rescan();
    void follow_hints();
    void quarantine_suspects();
    void end_quarantines();
    void postpone(MediaRecord record);
    void advance();
    void wake_at(std::optional<Schedule::Time> time, Schedule::Time begin);
    void perform(const Action& action);
    void start_analysis(const Action& action);
    void finish_analysis(const FileFacts& facts, const AnalysisOutcome& outcome);
    void store_answer(AnalysisOutcome outcome);
    void log_record(const MediaRecord& record);
    void request_thumbnails();
    StatusReport report() const;

    EventLoop& loop_;  // outlives this
    WatchOptions options_;
    Schedule schedule_;
    Liveness liveness_;
    FolderFollower follower_;
    HintFiles hint_files_;
    Weaver weaver_;
    Refiner refiner_;
    FileBook book_;
    Analyses analyses_;
    StatusWriter status_;
    MissingPictures pictures_;
    EventLoop::Source events_, wake_, rescan_;
};

}  // namespace vitrine::analyzer
