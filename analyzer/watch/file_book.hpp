#pragma once

#include "analyzer/store/store.hpp"
#include "analyzer/watch/file_states.hpp"
#include "analyzer/watch/film_growth.hpp"
#include "analyzer/watch/refiner.hpp"
#include "analyzer/watch/schedule.hpp"
#include "analyzer/watch/weaver.hpp"
#include "base/state/catalogue.hpp"
#include "base/system/event_loop.hpp"
#include "base/system/unique_fd.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The folders that FileBook writes to.
struct BookPlaces {
    std::filesystem::path catalogue;
    std::filesystem::path store;
    StoreBounds bounds;                // limits of the store
    std::filesystem::path thumbnails;  // only renamed here
};

/// Hear of each record that is stored or removed.
struct RecordFollowers {
    Weaver& weaver;
    Refiner& refiner;
};

/// All that the daemon remembers of each file, and the only writer of the catalogue. A record is stored,
/// renamed or removed here once, and whoever follows records hears of it: the store, the tapestries, the
/// states of the files. A path is forgotten as a whole. Logs.
class FileBook {
  public:
    /// @param followers  outlive this
    /// @throws std::system_error where the catalogue cannot be written, or another process writes it (EBUSY)
    FileBook(EventLoop& loop, const BookPlaces& places, Schedule& schedule, RecordFollowers followers);

    /// Reads the catalogue and tells the schedule what is in it. Files of version 0.1 get their names of
    /// today. Drops records that cannot be read.
    void load();

    /// The record of this path; nothing where there is none or it cannot be read.
    std::optional<MediaRecord> record(const std::string& path) const;

    /// Stores a whole record. On a full disk it is kept here until retry_writes().
    void store(const MediaRecord& record);

    /// Takes the regions of photos from records of the same content.
    void refine(const std::vector<MediaRecord>& found);

    /// Gives the record of `from` to `to`, and forgets `from`.
    /// @return false where there is no record: it was damaged, and is missing until the next start
    bool move(const std::string& from, const std::string& to);

    /// Removes the record and forgets the path.
    void remove(const std::string& path);

    /// Repeats what the disk refused.
    void retry_writes();

    /// Writes that the disk refused so far.
    struct Backlog {
        std::size_t records = 0;   // not stored
        std::size_t removals = 0;  // records still there
    };

    Backlog backlog() const;

    /// A child begins to analyse the file, and may be writing into the store.
    void begin_analysis(const std::string& path, const FileFacts& facts);

    /// The child has ended: publishes what it found so far, where the analysis still counts.
    void end_analysis(const std::string& path, const FileFacts& facts);

    /// Adds shots to a film that is being analysed; they are in the catalogue within half a second.
    void add_growth(const MediaRecord& part);

    /// Has films analysed again that are to be heard and have no sound in the store; the wall keeps their
    /// shots meanwhile.
    /// @param paths     all files
    /// @param is_heard  whether a film is shown with its sound
    /// @return whether the schedule has something new
    bool request_sounds(const std::vector<std::string>& paths,
                        const std::function<bool(const std::string& path)>& is_heard);

    /// @return whether to log this record: a file that keeps waiting is logged once
    bool is_news(const MediaRecord& record);

    /// Removes files from the store that go beyond its bounds; their shots are played from the media folder.
    void make_room();

    /// Removes files and tapestries that belong to no record.
    /// @param paths  all files
    void sweep(const std::vector<std::string>& paths);

    const FileStates& states() const { return states_; }

  private:
    struct File {
        std::unique_ptr<FilmGrowth> growth;     // while it is analysed, or its record is not complete
        std::unique_ptr<MediaRecord> unstored;  // the disk refused it
        bool is_unremoved = false;              // the disk refused to remove its record
        bool is_waiting_told = false;           // it is in the log that the file waits
        bool is_sound_checked = false;          // its stored sound has been checked; heard films only
    };

    void write_record(MediaRecord record);
    void remove_record(const std::string& path);
    void publish_growth();

    Catalogue catalogue_;
    UniqueFd lock_;
    Store store_;
    FileStates states_;
    Schedule& schedule_;  // outlives this
    RecordFollowers followers_;
    std::filesystem::path thumbnails_;
    std::map<std::string, File> files_;  // files with more to remember than their record
    bool is_lack_told_ = false;          // it is in the log that the disk refuses
    bool is_growth_resting_ = false;     // parts of films were written a moment ago
    EventLoop::Source growth_;
};

}  // namespace vitrine::analyzer
