#pragma once

#include "base/state/catalogue.hpp"
#include "base/system/directory_watch.hpp"
#include "base/system/event_loop.hpp"
#include "player/scene/show_files.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace vitrine::player {

/// Paths of the ready files that a change of the catalogue touches.
struct CatalogueChange {
    std::vector<std::string> added;
    std::vector<std::string> grown;  // the same content with further shots: a playing shot goes on
    std::vector<std::string> replaced;
    std::vector<std::string> gone;
    bool has_others = false;  // the records of files that are not ready have changed, too

    bool is_empty() const {
        return added.empty() && grown.empty() && replaced.empty() && gone.empty() && !has_others;
    }
};

/// True: the analyzer has found shots in the file.
bool is_ready(const MediaRecord& record);

/// Keeps the records of a catalogue up to date while the event loop runs. Waits for the directory if it does
/// not exist yet. Logs.
class CatalogueFollower {
  public:
    using Call = std::function<void(const CatalogueChange& change, const RecordList& records)>;

    /// @param loop  outlives this
    /// @param call  called on each change; the first time by this constructor
    CatalogueFollower(EventLoop& loop, Catalogue catalogue, Call call);

    /// All records, ready or not, ordered by path.
    const RecordList& records() const { return records_; }

    /// The number of records in each state.
    const std::map<MediaState, std::size_t>& counts() const { return counts_; }

  private:
    void watch();
    void read_events();
    void reload();

    Catalogue catalogue_;
    Call call_;
    RecordList records_;
    std::map<MediaState, std::size_t> counts_;
    std::map<std::string, std::string> complaints_;  // file -> reason; each is logged once
    DirectoryWatch directory_watch_;
    EventLoop::Source events_;
    EventLoop::Source settled_;  // fires a moment after the last change
    EventLoop::Source retry_;    // armed until the directory exists
};

/// Compares two lists of records that are ordered by path.
CatalogueChange change_between(const RecordList& before, const RecordList& after);

}  // namespace vitrine::player
