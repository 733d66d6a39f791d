#pragma once

#include "analyzer/tapestry/tapestries.hpp"
#include "analyzer/watch/child_process.hpp"
#include "analyzer/watch/weave_schedule.hpp"
#include "base/system/event_loop.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// How tapestries are woven.
struct WeaveOptions {
    std::filesystem::path root;        // of the media
    std::filesystem::path state;       // directory
    StoreBounds bounds;                // max_bytes 0: no tapestries
    std::vector<std::string> command;  // to which the folder and the film are appended
    ChildLimits limits;
};

/// Has the tapestries of the films woven that the daemon has records of, in a child of its own and only while
/// nothing is analysed; logs.
class Weaver {
  public:
    Weaver(EventLoop& loop, WeaveOptions options);
    Weaver(const Weaver&) = delete;
    Weaver& operator=(const Weaver&) = delete;
    ~Weaver() = default;

    /// See Tapestries.
    void hold(const MediaRecord& record);
    void release(const std::string& path);
    void move(const std::string& from, const std::string& to);

    /// A child has ended that analysed the film, and may have kept frames of it.
    void analysed(const std::string& path) { tapestries_.look_at(path); }

    /// From time to time. @param files  all that there are
    void sweep(const std::vector<std::string>& files);

    /// @param is_free  nothing is to be analysed, and the films are there
    void advance(bool is_free);

  private:
    void perform(const WeaveAction& action);
    void start(const std::string& path);
    void finish(const std::string& path, const ChildResult& result);
    void make_room();

    EventLoop& loop_;  // outlives this
    WeaveOptions options_;
    Tapestries tapestries_;
    WeaveSchedule schedule_;
    std::unique_ptr<ChildProcess> child_;
    bool was_free_ = false;
};

}  // namespace vitrine::analyzer
