#pragma once

#include "base/system/event_loop.hpp"
#include "base/system/unique_fd.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace vitrine::analyzer {

/// The limits of one child.
struct ChildLimits {
    std::chrono::milliseconds deadline{120'000};  // elapsed time, and the same of processor time per core
    std::uint64_t memory_bytes = 0;               // private memory it may ask for; 0: as much as there is
    std::size_t output_bytes = 64U << 20;         // on its standard output
    int niceness = 10;                            // added to ours
};

/// The limits for a file: larger ones take longer.
/// @param limits                 those of an empty file
/// @param deadline_per_mebibyte  seconds
ChildLimits limits_for(ChildLimits limits, double deadline_per_mebibyte, std::uint64_t bytes);

/// The end of a child, and its output.
struct ChildResult {
    enum class End {
        exited,           // by itself, with `code`
        killed,           // by the signal `code`, not sent by us
        late,             // killed at the deadline
        talked_too_much,  // killed for its output
        stopped,          // killed because stop() was called
    };

    End end = End::exited;
    int code = 0;
    std::string output;  // its standard output, at most ChildLimits::output_bytes; only the last line where
                         // `said` got the lines
    std::string complaint;  // the end of its standard error, at most max_complaint bytes
};

/// Runs another program in a process group of its own, with limits and a deadline. Nothing that happens in it
/// ends this process. It dies with this process, gains no privileges and leaves no core file.
class ChildProcess {
  public:
    static constexpr std::size_t max_complaint = 4096;

    /// Gets each line of the standard output as soon as it is whole, without its end.
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

    /// Stops the process until go_on(); its deadline goes on.
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
    EventLoop::Source process_source_, output_source_, complaint_source_, deadline_;
};

}  // namespace vitrine::analyzer
