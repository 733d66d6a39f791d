#pragma once

#include "base/state/visibility.hpp"
#include "player/content/judged_files.hpp"
#include "player/scene/files/moments.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <set>
#include <string>

namespace vitrine::player {

/// The content of STATE/visible.json. A copy costs little.
struct VisibleState {
    JudgedFiles::List files;
    std::set<std::string> on_wall;  // paths of the files that are shown now
    GroupList groups;
    RecordList records;  // the whole catalogue
};

/// The same judgement of a file that may be shown, with what hangs: itself, or another of its group; and with
/// its moment.
FileVisibility seen_on(FileVisibility file, const std::set<std::string>& on_wall, const GroupList& groups,
                       const Moments& moments);

/// Keeps STATE/visible.json up to date. The file is replaced by rename, at most once a second, for many files
/// less often, and only if its content has changed. In between its time is set, as proof that the player
/// runs. A thread of its own makes the text and writes the file, because both may take long. Logs.
class VisibleNote {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using Look = std::function<VisibleState()>;

    /// @param file  empty: nothing is written
    explicit VisibleNote(std::filesystem::path file) : file_(std::move(file)) {}

    /// The state may have changed.
    void set_changed() { has_changed_ = true; }

    /// @param look  called if the file may have to be written
    void write_if_due(Time now, const Look& look);

    /// Call when the run ends in order.
    void remove();

  private:
    void write(VisibleState state);
    void set_time();
    void retry_later(Time now);

    std::filesystem::path file_;
    bool has_changed_ = true;
    std::optional<Time> looked_;  // time of the last look at the state
    std::optional<Time> told_;    // time of the last writing, or of the last setting of the file's time
    VisibleState state_;          // the content of the file
    Time next_writing_{};
    bool has_complained_ = false;
    std::future<bool> written_;  // last: its thread ends before the rest
};

}  // namespace vitrine::player
