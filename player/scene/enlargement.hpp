#pragma once

#include "player/layout/edit/wall_state.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// A shot of the wall that is large because somebody looks at it. It grows about its place and the others
/// make way; after a while all shots go back to their places. Source: Dynamic Media Assemblage, chapter 4,
/// "resizing"; the way back is ours.
class Enlargement {
  public:
    /// @param patience  time after which a tapped shot goes back
    Enlargement(const EditRules& rules, std::chrono::nanoseconds patience)
        : rules_(rules), patience_(patience) {}

    /// Enlarges this shot for a while; if it is large already it goes back.
    void toggle(SourceId source);

    /// Enlarges this shot until end().
    void hold(SourceId source);

    void end() { wish_ = 0; }

    /// True while a shot is large, or is to be.
    bool is_on() const { return large_ != 0 || wish_ != 0; }

    /// The next change of the wall towards what is wished.
    /// @param wall    as it stands
    /// @param canvas  px
    /// @return        one placement for each shot of the wall; none: nothing is to be moved
    std::optional<std::vector<Placement>> next_placements(std::span<const PlacedShot> wall, Vec2 canvas,
                                                          std::chrono::nanoseconds now);

  private:
    std::vector<Placement> go_back();
    std::optional<std::vector<Placement>> enlarge(std::span<const PlacedShot> wall, Vec2 canvas);

    EditRules rules_;
    std::chrono::nanoseconds patience_;
    SourceId wish_ = 0;                  // 0: none
    SourceId large_ = 0;                 // 0: none
    bool is_held_ = false;               // it stays large however long it takes
    std::chrono::nanoseconds since_{0};  // when it became large
    std::vector<SourceId> sources_;      // the wall's sources at that time
    std::vector<Placement> before_;      // one for each of these sources
};

}  // namespace vitrine::player
