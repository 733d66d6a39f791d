#pragma once

#include "analyzer/child/child_deadline.hpp"
#include "analyzer/child/progress_rule.hpp"
#include "base/system/event_loop.hpp"
#include "base/system/unique_fd.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace vitrine::analyzer {

/// The limits of one child.
struct ChildLimits {
    Patience patience;                     // until it gives a sign of progress: any output is one
    std::uint64_t memory_bytes = 0;        // private memory it may ask for; 0: as much as there is
    std::size_t output_bytes = 64U << 20;  // on its standard output
    int niceness = 10;                     // added to ours
};

/// The limits for a file: larger ones take longer.
/// @param limits                those of an empty file
/// @param seconds_per_mebibyte  further processor time without progress
ChildLimits limits_for(ChildLimits limits, double seconds_per_mebibyte, std::uint64_t bytes);

/// The end of a child, and its output.
struct ChildResult {
    enum class End {
        exited,           // by itself, with `code`
        killed,           // by the signal `code`, not sent by us
        late,             // killed: it computed for too long without progress
        idle,             // killed: it neither computed nor got on
        talked_too_much,  // killed for its output
        stopped,          // killed because stop() was called
    };

    End end = End::exited;
    int code = 0;
    std::string output;  // its standard output, at most ChildLimits::output_bytes; only the last line where
                         // `said` got the lines that are not empty
    std::string complaint;  // the end of its standard error, at most max_complaint bytes
};

/// Another program in a process group of its own, with limits: this process goes on whatever happens in it.
/// It dies with this process, gains no privileges and leaves no core file. A program that gets on has no
/// deadline.
class ChildProcess {
  public:
    static constexpr std::size_t max_complaint = 4096;
    static constexpr int exit_not_started = 127;  // a program that is missing; the code of a shell for this

    /// Gets each line of the standard output as soon as it is whole, without its end. Empty lines are only
    /// signs of progress.
    using Said = std::function<void(const std::string& line)>;

    /// @param command  the program's file and its arguments
    /// @param ended    called once from the loop; may destroy this object
    /// @param said     called from the loop, before `ended`; may not destroy this object
    /// @throws std::system_error where no process can be made; a program that is missing exits with 127
    ChildProcess(EventLoop& loop, const std::vector<std::string>& command, const ChildLimits& limits,
                 std::function<void(const ChildResult&)> ended, Said said = {});
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Kills what still runs, without waiting for it.
    ~ChildProcess();

    /// Stops the process until go_on().
    void pause();
    void go_on();

    /// Kills it; `ended` follows from the loop.
    void stop();

  private:
    void kill(ChildResult::End why);
    void read_output();
    bool read_some_output();
    void read_complaint();
    void reap();

    ChildLimits limits_;
    std::function<void(const ChildResult&)> ended_;
    Said said_;
    ChildResult result_;
    std::string line_;        // the unfinished one, where said_ hears lines
    std::size_t heard_ = 0;   // bytes of output so far
    bool is_killed_ = false;  // we killed it: result_.end says why
    pid_t pid_ = -1;          // -1: reaped
    UniqueFd process_, output_, complaint_;
    EventLoop::Source process_source_, output_source_, complaint_source_;
    std::optional<ChildDeadline> deadline_;
};

}  // namespace vitrine::analyzer
