#pragma once

#include "base/system/event_loop.hpp"
#include "base/system/unique_fd.hpp"

#include <chrono>
#include <functional>
#include <thread>

namespace vitrine {

/// Takes SIGTERM and SIGINT. A process whose main thread hangs, as in a call on a share that does not answer,
/// would never hear of them: a thread of this object does, and ends the process.
class StopRequest {
  public:
    struct Limit {
        std::chrono::milliseconds patience;  // from the signal to the end of this object
        int exit_code = 0;                   // of a process that takes longer
    };

    /// Blocks both signals in this thread, and in those that it starts later.
    /// @param loop  outlives this
    /// @param stop  called once from the loop
    /// @throws std::system_error
    StopRequest(EventLoop& loop, Limit limit, std::function<void()> stop);
    StopRequest(const StopRequest&) = delete;
    StopRequest& operator=(const StopRequest&) = delete;

    /// From here on nothing ends the process any more.
    ~StopRequest();

  private:
    void wait() const;

    Limit limit_;
    UniqueFd signals_, asked_, over_;
    EventLoop::Source source_;
    std::thread thread_;
};

}  // namespace vitrine
