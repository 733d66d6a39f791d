#pragma once

#include "base/state/visibility.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <vector>

namespace vitrine::player {

/// Keeps STATE/visible.json up to date: replaced by rename, at most once a second and only where it has
/// changed; in between its time is set, which tells that the player runs. A thread of its own writes the
/// file, as disks may take long. Logs.
class VisibleNote {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using List = std::function<std::vector<FileVisibility>()>;

    /// @param file  empty: nothing is written
    explicit VisibleNote(std::filesystem::path file) : file_(std::move(file)) {}

    /// The list may be another.
    void set_changed() { has_changed_ = true; }

    /// @param list  called where the file may have to be written
    void write_if_due(Time now, const List& list);

    /// The run ends as it should.
    void remove();

  private:
    void write(std::vector<FileVisibility> files);
    void set_time();
    void retry_later(Time now);

    std::filesystem::path file_;
    bool has_changed_ = true;
    std::optional<Time> looked_;         // at the list
    std::optional<Time> told_;           // the file was written, or its time was set
    std::vector<FileVisibility> files_;  // in the file
    bool has_complained_ = false;
    std::future<bool> written_;  // last: its thread ends before the rest
};

}  // namespace vitrine::player
