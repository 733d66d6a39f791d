#pragma once

#include "player/layout/edit/wall_state.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// A shot of the wall that is large because somebody looks at it. It grows about its place and the others
/// make room; after a while all shots return to their places. Source: Dynamic Media Assemblage, chapter 4,
/// "resizing"; the return is ours.
class Enlargement {
  public:
    /// @param patience  time after which a tapped shot returns
    Enlargement(const EditRules& rules, std::chrono::nanoseconds patience)
        : rules_(rules), patience_(patience) {}

    /// Enlarges this shot for a while; a shot that is large returns to its place.
    void toggle(SourceId source);

    /// Enlarges this shot until end().
    void hold(SourceId source);

    void end() { wish_ = 0; }

    /// True while a shot is large or shall become large.
    bool is_on() const { return large_ != 0 || wish_ != 0; }

    /// The next change of the wall towards the wish.
    /// @param wall    the present wall
    /// @param canvas  px
    /// @return        one placement for each shot of the wall; none: nothing moves
    std::optional<std::vector<Placement>> next_placements(std::span<const PlacedShot> wall, Vec2 canvas,
                                                          std::chrono::nanoseconds now);

  private:
    std::vector<Placement> go_back();
    std::optional<std::vector<Placement>> enlarge(std::span<const PlacedShot> wall, Vec2 canvas);

    EditRules rules_;
    std::chrono::nanoseconds patience_;
    SourceId wish_ = 0;                  // the shot that shall be large; 0: none
    SourceId large_ = 0;                 // the shot that is large; 0: none
    bool is_held_ = false;               // it stays large until end()
    std::chrono::nanoseconds since_{0};  // time at which it became large
    std::vector<SourceId> sources_;      // the wall's sources at that time
    std::vector<Placement> before_;      // the placements of these sources before
};

}  // namespace vitrine::player
