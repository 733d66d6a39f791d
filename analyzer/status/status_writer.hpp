#pragma once

#include "analyzer/status/player_copies.hpp"
#include "analyzer/status/status_folder.hpp"
#include "analyzer/status/status_report.hpp"
#include "analyzer/status/thumbnail_copies.hpp"
#include "base/system/event_loop.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

/// Writes the status of all files for those who drop them: STATE/status.json and the status folder of the
/// media folder, a moment after a change and then no more often than its size allows. Thumbnails are those
/// that the analysing children left in STATE/thumbnails. The player's files in STATE are its picture of the
/// wall, wall.jpg, how long each file was seen, played/, and the reasons why files are not on it,
/// visible.json. Where the media folder cannot be written, the folder is missing; where one of its files
/// cannot, the others are written. The log says so once. Runs in the loop.
class StatusWriter {
  public:
    using MakeReport = std::function<StatusReport()>;

    /// @param folder       the status folder's name; empty: only STATE/status.json is written
    /// @param make_report  called whenever the status is written
    StatusWriter(EventLoop& loop, std::filesystem::path root, const std::string& folder,
                 std::filesystem::path state, MakeReport make_report);

    /// The files have changed: the status is written soon.
    void touch();

    /// Writes at once.
    void write();

    /// Paths of ready files on the page that were without a thumbnail when it was written last.
    const std::vector<std::string>& lacking() const { return thumbnails_.lacking(); }

  private:
    void write_folder(const StatusReport& report);
    void copy_from_player();
    void look_at_player();
    void add_player(StatusReport& report);
    void write_part(const std::function<void()>& part);
    void end_complaints();

    std::filesystem::path state_;
    std::optional<StatusFolder> folder_;
    VisibleReader player_;
    MakeReport make_report_;
    EventLoop::Clock::duration rest_;  // between two writings
    std::optional<EventLoop::Clock::time_point> written_;
    bool is_due_ = false;
    std::string json_;  // the content of status.json
    ThumbnailCopies thumbnails_;
    PlayerCopies copies_;
    bool is_online_ = false;  // the media folder was there at the last writing
    bool is_clean_ = false;   // nothing half-written is left of an earlier run
    std::map<std::string, bool>
        complaints_;  // what cannot be written, as the log has it; true: seen this time
    EventLoop::Source due_, wall_;
};

}  // namespace vitrine::analyzer
