#pragma once

#include "analyzer/watch/child_process.hpp"

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Has the thumbnails made that the status page lacks, as of files that were analysed before there was one: a
/// child at a time, each file once in a run.
class MissingThumbnails {
  public:
    /// @param command  that makes one; the file's path is appended
    /// @param made     called from the loop after each child
    MissingThumbnails(EventLoop& loop, std::vector<std::string> command, const ChildLimits& limits,
                      std::function<void()> made);

    /// @param files  absolute; those that were tried before are left out
    void make(const std::vector<std::string>& files);

  private:
    void go_on();

    EventLoop& loop_;  // outlives this
    std::vector<std::string> command_;
    ChildLimits limits_;
    std::function<void()> made_;
    std::vector<std::string> wanted_;
    std::set<std::string> tried_;
    std::unique_ptr<ChildProcess> child_;
};

}  // namespace vitrine::analyzer
