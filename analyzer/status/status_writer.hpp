#pragma once

#include "analyzer/status/status_folder.hpp"
#include "analyzer/status/status_report.hpp"
#include "base/system/event_loop.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

/// Writes what is told to those who drop files: STATE/status.json and the status folder of the media folder,
/// a moment after something has changed and then no more often than its size allows. Thumbnails are those
/// that the analysing children left in STATE/thumbnails, the wall is the player's STATE/wall.jpg,
/// why a file is not on it stands in its STATE/visible.json. Where the
/// media folder cannot be written, the folder is missing; the log says so once. Runs in the loop.
class StatusWriter {
  public:
    using Ask = std::function<StatusReport()>;

    /// @param folder  the status folder's name; empty: only STATE/status.json is written
    /// @param ask     outlived by what it calls
    StatusWriter(EventLoop& loop, std::filesystem::path root, const std::string& folder,
                 std::filesystem::path state, Ask ask);

    /// Something has changed.
    void touch();

    /// Writes at once.
    void write();

    /// Ready files on the page that were without a thumbnail when it was written last.
    const std::vector<std::string>& lacking() const { return lacking_; }

  private:
    void write_folder(const StatusReport& report);
    void copy_thumbnails(const std::vector<StatusEntry>& files);
    void remove_surplus(const std::set<std::string>& wanted) const;
    void copy_wall();
    void look_at_player();
    void add_player(StatusReport& report);
    void complain(const std::exception& error);

    std::filesystem::path state_;
    std::optional<StatusFolder> folder_;
    VisibleReader player_;
    Ask ask_;
    EventLoop::Clock::duration rest_;  // between two writings
    std::optional<EventLoop::Clock::time_point> written_;
    bool is_due_ = false;
    std::string told_;                                               // in status.json
    std::vector<std::string> lacking_;                               // paths
    std::set<std::string> thumbnails_;                               // ids in the folder
    std::map<std::string, std::filesystem::file_time_type> copied_;  // thumbnails as they were in STATE
    bool has_wall_ = false;
    bool is_online_ = false;  // the media folder was there at the last writing
    std::string complaint_;
    EventLoop::Source due_, wall_;
};

}  // namespace vitrine::analyzer
