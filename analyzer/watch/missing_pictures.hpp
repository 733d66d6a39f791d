#pragma once

#include "analyzer/child/child_process.hpp"

#include <deque>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Makes pictures that are not there, one child process at a time: thumbnails of files that were analysed
/// before there was a status page, and the names of folders.
class MissingPictures {
  public:
    using Command = std::vector<std::string>;

    /// @param made  called from the loop after each child
    MissingPictures(EventLoop& loop, const ChildLimits& limits, std::function<void()> made);

    /// Runs a command after those that wait, unless it waits or runs already.
    void request(const Command& command);

    /// Runs a command unless it was asked for before.
    void request_once(const Command& command);

    /// True where no child runs and no command waits.
    bool is_idle() const { return waiting_.empty(); }

  private:
    void start_next();

    EventLoop& loop_;  // outlives this
    ChildLimits limits_;
    std::function<void()> made_;
    std::deque<Command> waiting_;  // the first one runs
    std::set<Command> asked_once_;
    std::unique_ptr<ChildProcess> child_;
};

}  // namespace vitrine::analyzer
