#pragma once

#include "base/state/catalogue.hpp"
#include "player/content/catalogue_change.hpp"
#include "player/scene/files/file_groups.hpp"
#include "player/scene/files/show_files.hpp"

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace vitrine::player {

/// The catalogue at one moment, and the way to it.
struct CatalogueNews {
    RecordList records;  // all, ordered by path
    GroupList groups;    // of these
    CatalogueChange change;
    std::map<MediaState, std::size_t> counts;
    std::map<std::string, std::string> unreadable;  // new ones: file -> reason
};

/// Thread-safe. Reads records on a thread of its own, so that no picture waits for them, and only those that
/// changed.
class CatalogueReader {
  public:
    /// Reads nothing yet.
    /// @param on_news  called on the reader's thread when pop_news() has something; must not call back
    CatalogueReader(Catalogue catalogue, std::function<void()> on_news);
    CatalogueReader(const CatalogueReader&) = delete;
    CatalogueReader& operator=(const CatalogueReader&) = delete;

    /// Joins.
    ~CatalogueReader();

    /// Reads these files of the directory, which changed, came or went.
    void request_files(const std::set<std::string>& names);

    /// Reads the whole directory.
    void request_all();

    /// Waits until all that was requested so far has been read.
    void finish();

    /// Removes and returns what was read since the last call; nothing where that changed nothing.
    std::optional<CatalogueNews> pop_news();

  private:
    using Records = std::vector<RecordList::Record>;

    /// The files to read.
    struct Request {
        bool is_all = false;
        std::set<std::string> names;

        bool is_empty() const { return !is_all && names.empty(); }
    };

    void run();
    CatalogueNews read(Request request);
    void update_list(const Records& before, const Records& after);
    RecordList::Record read_record(const std::string& name, CatalogueNews& news);

    const Catalogue catalogue_;
    const std::function<void()> on_news_;
    std::map<std::string, RecordList::Record>
        records_;                               // by the name of the file; only the reader's thread uses it
    RecordList list_;                           // likewise: the same records by path
    FileGroups groups_;                         // likewise
    std::map<MediaState, std::size_t> counts_;  // likewise
    std::set<std::string> unreadable_;          // likewise
    std::mutex mutex_;
    std::condition_variable wake_;
    Request request_;                    // guarded by mutex_
    bool is_reading_ = false;            // likewise
    bool is_stopping_ = false;           // likewise
    std::optional<CatalogueNews> news_;  // likewise
    std::thread thread_;                 // last: runs on all of the above
};

}  // namespace vitrine::player
