#pragma once

#include "player/layout/edit/wall_state.hpp"
#include "player/scene/crossfade.hpp"

#include <chrono>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// A shot of the wall that is large because somebody looks at it. It grows about its place, the others make
/// way; by itself, after a while, all goes back to where it was.
/// Source: Dynamic Media Assemblage, chapter 4, "resizing"; the way back is ours.
class Enlargement {
  public:
    /// @param patience  after which what was tapped goes back
    Enlargement(const EditRules& rules, std::chrono::nanoseconds patience)
        : rules_(rules), patience_(patience) {}

    /// This shot shall be large, for a while; where it is already it goes back.
    void toggle(SourceId source);

    /// This one shall be large until end().
    void hold(SourceId source);

    /// Nothing shall be.
    void end() { wish_ = 0; }

    /// Whether a shot is large, or is to be.
    bool is_on() const { return large_ != 0 || wish_ != 0; }

    /// The next change of the wall to what is wished.
    /// @param wall    as it stands
    /// @param canvas  px
    /// @return        one placement for each shot of the wall; none: nothing is to be moved
    std::optional<std::vector<Placement>> step(std::span<const PlacedShot> wall, Vec2 canvas,
                                               std::chrono::nanoseconds now);

  private:
    std::vector<Placement> go_back();
    std::optional<std::vector<Placement>> enlarge(std::span<const PlacedShot> wall, Vec2 canvas);

    EditRules rules_;
    std::chrono::nanoseconds patience_;
    SourceId wish_ = 0;                  // 0: none
    SourceId large_ = 0;                 // 0: none
    bool is_held_ = false;               // no patience ends it
    std::chrono::nanoseconds since_{0};  // that it is large
    std::vector<SourceId> sources_;      // of the wall then
    std::vector<Placement> before_;      // one a source
};

}  // namespace vitrine::player
