#pragma once

#include <chrono>
#include <cstdint>

namespace vitrine::player {

/// Counts of a source since it was made.
struct ShotCounts {
    std::uint64_t due = 0;              // number of times that a picture was asked for
    std::uint64_t late = 0;             // number of times that it was not there
    std::chrono::nanoseconds spent{0};  // processor time of its film
};

/// Judges whether a film keeps up with the time that it has been shown, `local`, and decides what follows
/// where it does not: time gives way to it, or it is sent ahead (docs/architecture.md, "A film's clocks").
class ShotClock {
  public:
    /// @param keeps_time  a film that is too slow is sent ahead; else the shot falls behind `local`
    /// @param at          `local` at the begin
    ShotClock(bool keeps_time, std::chrono::nanoseconds at);

    /// The place, in loops of the shot, that is to be seen.
    std::chrono::nanoseconds target(std::chrono::nanoseconds local) const { return local - behind_; }

    /// Judges one time once: a second call with the same `local` does nothing.
    /// @param missing  the time for which a next picture has been missing; <= 0: none is missing
    /// @return whether the film is hopelessly late: it is to be sent to jump()
    bool judge(std::chrono::nanoseconds local, std::chrono::nanoseconds missing);

    /// The film is sent elsewhere now. @return the place, in loops, where it can play by the time it is there
    std::chrono::nanoseconds jump();

    /// The numbers of pictures that were due and that were late.
    ShotCounts counts() const { return {.due = due_, .late = late_}; }

    /// Stream times in Matroska are rounded to this.
    static constexpr std::chrono::nanoseconds rounding = std::chrono::milliseconds(1);

  private:
    bool keeps_time_;
    std::chrono::nanoseconds behind_{0};  // `local`, by decoding too slowly
    std::chrono::nanoseconds judged_;     // `local` when lateness was judged last; at first: before the begin
    std::chrono::nanoseconds jumped_;     // `local` when the film was last sent elsewhere
    std::uint64_t due_ = 0;
    std::uint64_t late_ = 0;
};

}  // namespace vitrine::player
