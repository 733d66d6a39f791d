#pragma once

#include "base/system/event_loop.hpp"

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace vitrine::analyzer {

/// The state of the service in one line, for `systemctl status`.
struct StatusLine {
    std::string text;
    bool has_running_times = false;  // the text tells how long something takes: it is sent again and again
};

/// Tells systemd that the analyzer lives. The watchdog is fed while all that must happen by some time has
/// happened: a loop that turns proves nothing. The status line is sent at most once a second. Logs.
class Liveness {
  public:
    using Time = std::chrono::steady_clock::time_point;

    static constexpr auto patience = std::chrono::seconds(60);  // after the time that was expected

    /// Feeds the watchdog for the first time as soon as the loop runs.
    Liveness(EventLoop& loop, std::function<StatusLine()> status);

    /// @param what  in plain words; expected anew under the same words, only the later time counts
    void expect(const std::string& what, Time until) { expected_[what] = until; }

    /// It has happened, or is not expected any more.
    void meet(const std::string& what) { expected_.erase(what); }

    /// The expectation that is overdue for longest; nothing where all is well.
    std::optional<std::string> overdue(Time now) const;

    /// Feeds the watchdog from inside a long step.
    void feed_watchdog_now();

    /// Sends the status line in a moment.
    void send_status_soon();

  private:
    void feed_watchdog();
    void send_status();

    std::function<StatusLine()> status_;
    std::map<std::string, Time> expected_;
    std::optional<Time> fed_;   // time of the last feeding
    std::string told_overdue_;  // why it is not fed, as the log has it
    bool is_sending_ = false;   // the status line is sent in a moment
    EventLoop::Source watchdog_, sending_;
};

}  // namespace vitrine::analyzer
