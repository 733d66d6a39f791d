#include "analyzer/watch/child_deadline.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

namespace vitrine::analyzer {

using namespace std::chrono_literals;

ChildDeadline::ChildDeadline(EventLoop& loop, pid_t pid, const Patience& patience,
                             std::function<void(ProgressRule::Verdict)> stuck)
    : rule_(patience),
      stuck_(std::move(stuck)),
      interval_(std::clamp(std::min(patience.computing, patience.idling) / 4, 10ms, 1000ms)),
      timer_(loop.timer([this] { look(); })) {
    if (::clock_getcpuclockid(pid, &clock_) != 0) return;  // it has ended already
    go_on();
}

void ChildDeadline::go_on() {
    looked_ = EventLoop::Clock::now();
    timer_.arm(interval_);
}

/// Where this process stood still, or was starved, not all of the time since the last look counts.
void ChildDeadline::look() {
    timespec used{};
    if (::clock_gettime(clock_, &used) != 0) return;  // it has ended: whoever waits for it hears of that
    const auto processor = std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec);
    const auto passed = std::min<std::chrono::nanoseconds>(EventLoop::Clock::now() - looked_, 2 * interval_);
    go_on();
    const ProgressRule::Verdict verdict = rule_.judge(passed, processor);
    if (verdict == ProgressRule::Verdict::fine) return;
    timer_.disarm();
    const auto stuck = std::move(stuck_);
    stuck(verdict);
}

}  // namespace vitrine::analyzer
