#pragma once

#include "base/state/catalogue.hpp"
#include "base/system/directory_watch.hpp"
#include "base/system/event_loop.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace vitrine::player {

/// What became of the files that can be shown, by path.
struct CatalogueChange {
    std::vector<std::string> added;
    std::vector<std::string> grown;  // the same content with further shots: what plays plays on
    std::vector<std::string> replaced;
    std::vector<std::string> gone;

    bool is_empty() const { return added.empty() && grown.empty() && replaced.empty() && gone.empty(); }
};

/// The ready records of a catalogue, kept up to date while the event loop runs. A directory that is not there
/// yet is awaited.
class CatalogueFollower {
  public:
    using Call = std::function<void(const CatalogueChange&)>;

    /// @param loop  outlives this
    /// @param call  for every change; the first one comes from here
    CatalogueFollower(EventLoop& loop, Catalogue catalogue, Call call);

    /// Ordered by path; those alone that are ready.
    const std::vector<MediaRecord>& records() const { return records_; }

    /// How many of all records are in which state.
    const std::map<MediaState, std::size_t>& counts() const { return counts_; }

  private:
    void watch();
    void read_events();
    void reload();

    Catalogue catalogue_;
    Call call_;
    std::vector<MediaRecord> records_;
    std::map<MediaState, std::size_t> counts_;
    std::map<std::string, std::string> complaints_;  // file -> reason, so that each is told once
    DirectoryWatch directory_watch_;
    EventLoop::Source events_;
    EventLoop::Source settled_;  // a moment after the last change
    EventLoop::Source retry_;    // until the directory is there
};

/// What changed from one list of records to another, both ordered by path.
CatalogueChange change_between(const std::vector<MediaRecord>& before, const std::vector<MediaRecord>& after);

}  // namespace vitrine::player
