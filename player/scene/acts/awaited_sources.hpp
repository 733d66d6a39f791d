#pragma once

#include "player/scene/frame.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <set>

namespace vitrine::player {

/// The sources that are ready on the box that leads and perhaps not on the others. They are held back until
/// all boxes have the shots of the last preparation, but at most five seconds.
class AwaitedSources {
  public:
    /// Counts a preparation, for which the others are waited for. @return its number, from 1
    std::uint64_t prepare(std::chrono::nanoseconds now);

    /// Counts a preparation that says more of the last one: the others are waited for as long as before.
    std::uint64_t prepare_again() { return ++preparations_; }

    /// @param ready  the others have all preparations up to this number; none: nobody is waited for
    void set_ready(std::optional<std::uint64_t> ready) { ready_ = ready; }

    bool is_waiting(std::chrono::nanoseconds now) const;

    void hold(SourceId source) { held_.insert(source); }

    void forget(SourceId source) { held_.erase(source); }

    /// The sources that are held back no longer.
    std::set<SourceId> take_free(std::chrono::nanoseconds now);

  private:
    std::set<SourceId> held_;
    std::optional<std::uint64_t> ready_;
    std::uint64_t preparations_ = 0;
    std::chrono::nanoseconds prepared_{0};  // when the last one was made
};

}  // namespace vitrine::player
