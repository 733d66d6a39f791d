#pragma once

#include "analyzer/child/child_process.hpp"

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Makes the thumbnails that the status page lacks, for files that were analysed before there was a page: one
/// child process at a time, each file once in a run.
class MissingThumbnails {
  public:
    /// @param command  makes one; the file's path is appended. Empty: none are made
    /// @param made     called from the loop after each child
    MissingThumbnails(EventLoop& loop, std::vector<std::string> command, const ChildLimits& limits,
                      std::function<void()> made);

    /// @param files  absolute; those that were tried before are left out
    void request(const std::vector<std::string>& files);

  private:
    void start_next();

    EventLoop& loop_;  // outlives this
    std::vector<std::string> command_;
    ChildLimits limits_;
    std::function<void()> made_;
    std::vector<std::string> wanted_;
    std::set<std::string> tried_;
    std::unique_ptr<ChildProcess> child_;
};

}  // namespace vitrine::analyzer
