#pragma once

#include "base/state/visibility.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <vector>

namespace vitrine::player {

/// Keeps STATE/visible.json up to date. The file is replaced by rename, at most once a second and only if its
/// content has changed. In between its time is set, as proof that the player runs. A thread of its own writes
/// the file, because disks may be slow. Logs.
class VisibleNote {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using List = std::function<std::vector<FileVisibility>()>;

    /// @param file  empty: nothing is written
    explicit VisibleNote(std::filesystem::path file) : file_(std::move(file)) {}

    /// The list may have changed.
    void set_changed() { has_changed_ = true; }

    /// @param list  called if the file may have to be written
    void write_if_due(Time now, const List& list);

    /// Call when the run ends in order.
    void remove();

  private:
    void write(std::vector<FileVisibility> files);
    void set_time();
    void retry_later(Time now);

    std::filesystem::path file_;
    bool has_changed_ = true;
    std::optional<Time> looked_;  // time of the last look at the list
    std::optional<Time> told_;    // time of the last writing, or of the last setting of the file's time
    std::vector<FileVisibility> files_;  // the content of the file
    bool has_complained_ = false;
    std::future<bool> written_;  // last: its thread ends before the rest
};

}  // namespace vitrine::player
