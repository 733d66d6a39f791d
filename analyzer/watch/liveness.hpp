#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>

namespace vitrine::analyzer {

/// Whether the daemon gets on with what it is for, and so whether systemd may be told that all is well. A
/// loop that turns proves nothing: whatever must have happened by some time is kept here until it has. Knows
/// no clock: time is passed in.
class Pulse {
  public:
    using Time = std::chrono::steady_clock::time_point;

    static constexpr auto patience = std::chrono::seconds(60);  // behind the time that was expected

    /// @param what  in plain words; expected anew under the same ones, only the later time counts
    void expect(const std::string& what, Time until) { expected_[what] = until; }

    void came(const std::string& what) { expected_.erase(what); }

    /// What has been missed for longest; nothing where all is well.
    std::optional<std::string> missed(Time now) const;

  private:
    std::map<std::string, Time> expected_;
};

}  // namespace vitrine::analyzer
