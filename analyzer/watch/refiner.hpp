#pragma once

#include "analyzer/child/child_process.hpp"
#include "base/state/record.hpp"
#include "base/system/event_loop.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The options of refining.
struct RefineOptions {
    std::filesystem::path root;        // the media folder
    std::vector<std::string> command;  // prints one record; the photo is appended. Empty: nothing is refined
    ChildLimits limits;
    std::size_t children = 1;  // at the same time
};

/// Finds the regions of photos once more, by the network that knows things: it takes about a second of
/// processor time for each, so that a photo is on the wall with its plain region before. Runs child processes
/// only while nothing is analysed, the newest photo first. A photo is tried once in a run. Logs.
///
/// Each new region changes the wall. So regions are handed over together: when no photo is left, at the
/// latest some seconds after the first of them was found.
class Refiner {
  public:
    static constexpr int max_failures = 3;  // in a row; then the network is taken for broken

    /// Gets records whose shots have their regions from the network.
    using Refined = std::function<void(const std::vector<MediaRecord>& records)>;

    /// @param refined  called from the loop
    Refiner(EventLoop& loop, RefineOptions options, Refined refined);
    Refiner(const Refiner&) = delete;
    Refiner& operator=(const Refiner&) = delete;
    ~Refiner() = default;

    /// There is this record now; its region is refined where it is a photo that the network has not seen.
    void note_record(const MediaRecord& record);

    /// There is no record of this path any more.
    void forget_file(const std::string& path) { wishes_.erase(path); }

    /// Starts children.
    /// @param is_free  nothing is to be analysed, and the media are there
    void advance(bool is_free);

    /// Photos that wait, or have a child.
    std::size_t backlog() const { return wishes_.size() + running_.size(); }

  private:
    /// A content, to tell it from the next one of the same path.
    struct Content {
        std::uint64_t bytes = 0;
        std::int64_t mtime_ns = 0;

        bool operator==(const Content&) const = default;
    };

    void start_child(const std::string& path);
    void finish_child(const std::string& path, const ChildResult& result);
    void note_failure(const std::string& path, const std::string& reason);
    void hand_over();

    EventLoop& loop_;  // outlives this
    RefineOptions options_;
    Refined refined_;
    std::map<std::string, Content> wishes_;
    std::map<std::string, Content> tried_;
    std::map<std::string, std::unique_ptr<ChildProcess>> running_;
    std::vector<MediaRecord> found_;  // not handed over yet
    int failures_ = 0;                // in a row
    bool is_free_ = false;
    EventLoop::Source hand_over_;
};

}  // namespace vitrine::analyzer
