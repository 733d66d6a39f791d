#include "analyzer/child/child_deadline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <utility>

namespace vitrine::analyzer {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

/// The time for which the threads of a process that live now could have run and others had the processors.
std::chrono::nanoseconds kept_waiting(pid_t pid) {
    std::chrono::nanoseconds sum{0};
    std::error_code ended;
    for (const fs::directory_entry& thread :
         fs::directory_iterator(fmt::format("/proc/{}/task", pid), ended)) {
        std::int64_t ran = 0;
        std::int64_t waited = 0;
        if (std::ifstream(thread.path() / "schedstat") >> ran >> waited)
            sum += std::chrono::nanoseconds(waited);
    }
    return sum;
}

}  // namespace

ChildDeadline::ChildDeadline(EventLoop& loop, pid_t pid, const Patience& patience,
                             std::function<void(ProgressRule::Verdict)> stuck)
    : rule_(patience),
      stuck_(std::move(stuck)),
      pid_(pid),
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
    const ProgressRule::Verdict verdict = rule_.judge(passed, processor, kept_waiting(pid_));
    if (verdict == ProgressRule::Verdict::fine) return;
    timer_.disarm();
    const auto stuck = std::move(stuck_);
    stuck(verdict);
}

}  // namespace vitrine::analyzer
