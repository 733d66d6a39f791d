#pragma once

#include <chrono>
#include <cstdint>

namespace vitrine::player {

/// Counts of a source since it was created.
struct ShotCounts {
    std::uint64_t due = 0;              // times that a picture was due
    std::uint64_t late = 0;             // times that it was missing
    std::chrono::nanoseconds spent{0};  // processor time of its film
};

/// Judges whether a film keeps up with the time that it has been shown, `local`. If not, the shot's time is
/// set back, or the film is sent ahead (docs/architecture.md, "A film's clocks").
class ShotClock {
  public:
    /// @param keeps_time  true: a film that is too slow is sent ahead; false: the shot falls behind `local`
    /// @param at          `local` at the start
    ShotClock(bool keeps_time, std::chrono::nanoseconds at);

    /// The place to be seen, in time over all loops.
    std::chrono::nanoseconds target(std::chrono::nanoseconds local) const { return local - behind_; }

    /// Judges each time once: a second call with the same `local` does nothing.
    /// @param missing  for how long the next picture has been missing; <= 0: it is not missing
    /// @return true: the film is hopelessly late, send it to jump()
    bool judge(std::chrono::nanoseconds local, std::chrono::nanoseconds missing);

    /// Notes that the film is sent ahead. @return the place, over all loops, that it can play when it gets
    /// there
    std::chrono::nanoseconds jump();

    /// The numbers of due and of late pictures.
    ShotCounts counts() const { return {.due = due_, .late = late_}; }

    /// Matroska rounds stream times to this.
    static constexpr std::chrono::nanoseconds rounding = std::chrono::milliseconds(1);

  private:
    bool keeps_time_;
    std::chrono::nanoseconds behind_{0};  // the time by which the shot is behind `local`
    std::chrono::nanoseconds judged_;     // `local` of the last judgement; at first a time before the start
    std::chrono::nanoseconds jumped_;     // `local` at the last jump
    std::uint64_t due_ = 0;
    std::uint64_t late_ = 0;
};

}  // namespace vitrine::player
