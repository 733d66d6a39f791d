#pragma once

#include "player/layout/edit/wall_state.hpp"
#include "player/scene/crossfade.hpp"

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace vitrine::player {

/// Whether a shot shows this canvas point.
bool is_touched(const PlacedShot& placed, Vec2 point);

/// A finger on the wall, and the shot that it holds. What is held follows it, the others make way and go back
/// once it has passed; where it is lifted all settles.
/// Source: Dynamic Media Assemblage, chapter 4 and fig. 4.1.
class Drag {
  public:
    explicit Drag(const EditRules& rules) : rules_(rules) {}

    /// Where the finger is and where it came down, canvas px.
    void touch(Vec2 finger, Vec2 from) {
        finger_ = finger;
        from_ = from;
    }

    /// The finger is lifted.
    void lift() { finger_.reset(); }

    /// What is held is gone.
    void forget();

    /// Whether a shot is held, or was dropped and has not been settled yet.
    bool is_holding() const { return held_ != 0; }

    /// Whether a finger is there, or a shot is held still.
    bool is_wanted() const { return finger_ || is_holding(); }

    /// What is held, and where it stood when it was taken; none: nothing.
    std::optional<std::pair<SourceId, Placement>> held() const;

    /// The next step of the wall after the finger.
    /// @param wall    as it stands, with cells
    /// @param canvas  px
    /// @return        one placement for each shot of the wall; none: nothing is to be moved
    std::optional<std::vector<Placement>> step(std::span<const PlacedShot> wall, Vec2 canvas);

  private:
    void take_hold(std::span<const PlacedShot> wall);
    WallState standing_wall(std::span<const PlacedShot> wall, Vec2 canvas) const;
    WallState making_way(const WallState& wall, std::size_t held, Vec2 wish) const;

    EditRules rules_;
    std::optional<Vec2> finger_;
    Vec2 from_;
    bool has_tried_ = false;               // to take hold where the finger came down
    SourceId held_ = 0;                    // 0: nothing
    Vec2 grip_;                            // from the finger to the centroid of the region held, canvas px
    Placement home_;                       // of what is held, when it was taken
    std::map<SourceId, Placement> homes_;  // when it was taken
};

}  // namespace vitrine::player
