#pragma once

#include "player/layout/edit/wall_state.hpp"
#include "player/scene/wall_shot.hpp"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// A shot of the wall that a finger holds. It follows the finger. The others make room, and return once it
/// has passed. When the finger is lifted, all shots settle. Source: Dynamic Media Assemblage, chapter 4 and
/// fig. 4.1.
class Drag {
  public:
    /// The held shot, and its place when it was taken hold of.
    struct Held {
        SourceId source = 0;
        Placement home;
    };

    explicit Drag(const EditRules& rules) : rules_(rules) {}

    /// @param finger, from  present place of the finger, and the place where it came down, canvas px
    void follow_finger(Vec2 finger, Vec2 from) {
        finger_ = finger;
        from_ = from;
    }

    void lift_finger() { finger_.reset(); }

    /// Call when the held shot leaves the wall.
    void let_go();

    /// True while a finger is down, or a shot was dropped and has not settled yet.
    bool is_active() const { return finger_ || held_; }

    const std::optional<Held>& held() const { return held_; }

    /// The next step of the wall towards the finger.
    /// @param wall    the present wall, with cells
    /// @param canvas  px
    /// @return        one placement for each shot of the wall; none: nothing moves
    std::optional<std::vector<Placement>> next_placements(std::span<const PlacedShot> wall, Vec2 canvas);

  private:
    void take_hold(std::span<const PlacedShot> wall);
    WallState standing_wall(std::span<const PlacedShot> wall, Vec2 canvas) const;
    WallState making_way(const WallState& wall, std::size_t held, Vec2 wish) const;

    EditRules rules_;
    std::optional<Vec2> finger_;
    Vec2 from_;
    bool has_tried_ = false;  // a try to take hold of a shot where the finger came down
    std::optional<Held> held_;
    Vec2 grip_;                            // from the finger to the centroid of the held I-Region, canvas px
    std::map<SourceId, Placement> homes_;  // places of all shots when the held one was taken
};

}  // namespace vitrine::player
