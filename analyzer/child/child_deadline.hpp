#pragma once

#include "analyzer/child/progress_rule.hpp"
#include "base/system/event_loop.hpp"

#include <functional>

#include <sys/types.h>

namespace vitrine::analyzer {

/// Looks at a child process again and again, and says when it must be ended.
class ChildDeadline {
  public:
    /// @param stuck  called once from the loop; may destroy this object
    ChildDeadline(EventLoop& loop, pid_t pid, const Patience& patience,
                  std::function<void(ProgressRule::Verdict)> stuck);
    ChildDeadline(const ChildDeadline&) = delete;
    ChildDeadline& operator=(const ChildDeadline&) = delete;
    ~ChildDeadline() = default;

    void note_progress() { rule_.note_progress(); }

    /// Stops looking: the child is paused.
    void pause() { timer_.disarm(); }

    void go_on();

  private:
    void look();

    ProgressRule rule_;
    std::function<void(ProgressRule::Verdict)> stuck_;
    clockid_t clock_{};  // the child's processor time
    pid_t pid_;
    std::chrono::milliseconds interval_;
    EventLoop::Clock::time_point looked_;
    EventLoop::Source timer_;
};

}  // namespace vitrine::analyzer
