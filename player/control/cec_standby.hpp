#pragma once

#include <sys/types.h>

namespace vitrine::player {

/// Asks television sets over HDMI-CEC to go to standby and to wake, with Debian's `cec-ctl` where it is
/// installed. A set that does not answer, and a machine without CEC, change nothing: the signal decides.
class CecStandby {
  public:
    CecStandby() = default;
    CecStandby(const CecStandby&) = delete;
    CecStandby& operator=(const CecStandby&) = delete;
    CecStandby(CecStandby&&) = delete;
    CecStandby& operator=(CecStandby&&) = delete;

    /// Ends a question that is still under way.
    ~CecStandby();

    /// Does not wait.
    void ask(bool is_on);

    /// Call now and then: the tool has no other parent.
    void look();

  private:
    pid_t tool_ = -1;  // -1: none runs
};

}  // namespace vitrine::player
