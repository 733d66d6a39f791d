#pragma once

#include <chrono>

namespace vitrine::analyzer {

/// The time for which a child may go on without progress.
struct Patience {
    std::chrono::milliseconds computing{120'000};  // processor time
    std::chrono::milliseconds idling{120'000};     // time in which it computes next to nothing
};

/// Tells a child that is stuck from one that is slow. Only its own processor time is held against it, so that
/// neither a busy machine nor a pause of this process ends it. Pure: times are passed in.
class ProgressRule {
  public:
    using Duration = std::chrono::nanoseconds;

    enum class Verdict {
        fine,
        computing,  // it computes and gets nowhere: the file is at fault
        idling,     // it waits for something that does not come: the file's share, a disk
    };

    explicit ProgressRule(const Patience& patience) : patience_(patience) {}

    /// The child got on.
    void note_progress() { has_progressed_ = true; }

    /// @param passed     time since the last look, less what this process itself stood still
    /// @param processor  processor time that the child has used so far
    /// @param kept       time for which the child could have computed so far, and others had the processors
    Verdict judge(Duration passed, Duration processor, Duration kept = Duration(0));

  private:
    Patience patience_;
    bool has_progressed_ = false;  // since the last look
    Duration at_progress_{0};      // the child's processor time when it last got on
    Duration at_look_{0};          // its processor time and what it was kept from, at the last look
    Duration idle_{0};             // as long it has computed next to nothing
};

}  // namespace vitrine::analyzer
