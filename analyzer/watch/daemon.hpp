#pragma once

#include "analyzer/one_file/analysis_outputs.hpp"
#include "analyzer/status/status_writer.hpp"
#include "analyzer/store/store.hpp"
#include "analyzer/store/store_place.hpp"
#include "analyzer/watch/analyses.hpp"
#include "analyzer/watch/file_book.hpp"
#include "analyzer/watch/folder_follower.hpp"
#include "analyzer/watch/hint_files.hpp"
#include "analyzer/watch/liveness.hpp"
#include "analyzer/watch/missing_pictures.hpp"
#include "analyzer/watch/schedule.hpp"
#include "analyzer/watch/weaver.hpp"
#include "base/settings/choices.hpp"
#include "base/system/event_loop.hpp"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The words that the player needs as pictures, besides the names of folders.
struct WordSettings {
    CaptionChoice captions = CaptionChoice::none;
    std::string wall_code;      // the text of the wall's QR code; empty: none
    std::string share_address;  // on the idle picture; empty: none
    bool tells_years = false;   // captions also with the year
};

/// All that the daemon needs to know.
struct WatchOptions {
    std::filesystem::path root;       // the media folder
    std::filesystem::path catalogue;  // the directory of records
    std::filesystem::path store;
    std::filesystem::path state;               // hints.json, status.json, thumbnails/, words/ and wall.jpg
    std::vector<std::string> thumbnail_child;  // makes a thumbnail; the file is appended. Empty: none is made
    std::vector<std::string> words_child;      // sets words; they are appended. Empty: none are set
    WordSettings words;
    std::string status_folder;  // in the media folder, for its operators; empty: none
    StoreBounds bounds{.max_bytes = 0, .min_free_bytes = usual_free_bytes};
    AnalysisCommand analysis;
    AnalysisOutputs outputs;          // each analysis writes these
    std::vector<std::string> weave;   // the command that weaves a tapestry; see WeaveOptions
    std::vector<std::string> refine;  // the command that finds a region by the network; see RefineOptions
    StoreBounds tapestries{.max_bytes = 0, .min_free_bytes = usual_free_bytes};
    Pace pace;
    std::chrono::milliseconds rescan{60'000};
    bool is_once = false;  // ends the loop as soon as the catalogue is up to date and all films are woven
    bool weaves = true;    // false: tapestries are left to a later run
};

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

    /// Has the pictures of other words made, and removes those of words that are not wanted any more.
    void change_words(WordSettings words);

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
