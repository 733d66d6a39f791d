#pragma once

#include "base/state/catalogue.hpp"
#include "base/system/directory_watch.hpp"
#include "base/system/event_loop.hpp"
#include "base/system/unique_fd.hpp"
#include "player/content/catalogue_change.hpp"
#include "player/content/catalogue_reader.hpp"
#include "player/scene/files/show_files.hpp"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace vitrine::player {

/// Keeps the records of a catalogue up to date while the event loop runs. Where the directory does not exist
/// yet, the follower waits for it. Logs.
class CatalogueFollower {
  public:
    using Call = std::function<void(const CatalogueChange& change, const RecordList& records,
                                    const GroupList& groups)>;

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
    void request_changed();
    void follow_news();

    std::filesystem::path directory_;
    Call call_;
    RecordList records_;
    std::map<MediaState, std::size_t> counts_;
    DirectoryWatch directory_watch_;
    std::set<std::string> changed_;  // files that are still to be read
    std::optional<EventLoop::Clock::time_point> changed_since_;
    UniqueFd news_;  // an event_file(): the reader has news
    EventLoop::Source events_;
    EventLoop::Source settled_;  // fires a moment after the last change
    EventLoop::Source retry_;    // armed until the directory exists
    EventLoop::Source told_;     // fires when there are news
    CatalogueReader reader_;     // last: its thread uses news_
};

}  // namespace vitrine::player
