#pragma once

#include "player/layout/standing.hpp"
#include "player/scene/compose.hpp"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace vitrine {

/// A finger on the wall, and the shot that it holds. What is held follows it, the others make way and go back
/// once it has passed; where it is lifted all settles.
/// Source: Dynamic Media Assemblage, chapter 4 and fig. 4.1.
class Hand {
  public:
    explicit Hand(const EditRules& rules) : rules_(rules) {}

    /// Where the finger is, canvas px; none: it is not on the wall.
    void touch(std::optional<Vec2> finger) { finger_ = finger; }

    /// Whether a shot is held, or was dropped and has not been settled yet.
    bool is_holding() const { return held_ != 0; }

    /// The next step of the wall after the finger.
    /// @param wall    as it stands, with cells
    /// @param canvas  px
    /// @return        one placement for each shot of the wall; none: nothing is to be moved
    std::optional<std::vector<Placement>> step(std::span<const PlacedShot> wall, Vec2 canvas);

  private:
    void take_hold(std::span<const PlacedShot> wall);
    Standing standing_wall(std::span<const PlacedShot> wall, Vec2 canvas) const;
    Standing making_way(const Standing& wall, std::size_t held, Vec2 wish) const;

    EditRules rules_;
    std::optional<Vec2> finger_;
    bool has_tried_ = false;               // to take hold where the finger came down
    SourceId held_ = 0;                    // 0: nothing
    Vec2 grip_;                            // from the finger to the centroid of the region held, canvas px
    Placement home_;                       // of what is held, when it was taken
    std::map<SourceId, Placement> homes_;  // when it was taken
};

}  // namespace vitrine
