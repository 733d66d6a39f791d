#pragma once

#include "player/scene/lifted_shots.hpp"

#include <chrono>
#include <map>
#include <span>

namespace vitrine::player {

/// The shots that hands hold above a wall of several boxes, on a box that follows. Without news they go back
/// after a second.
class FollowedLifted {
  public:
    /// Takes what the leader has drawn last. @param now  of this box
    void take(LiftedMoment seen, std::chrono::nanoseconds now);

    /// Draws the shots above a wall, and the film of a photo. @param frame  of the wall, in the leader's time
    /// @param wall            the shots are lifted off this
    /// @param is_film_ready   false: the film is not drawn
    /// @param now             of this box
    void draw(Frame& frame, std::span<const PlacedShot> wall, bool is_film_ready,
              std::chrono::nanoseconds now);

    bool is_empty() const { return lifted_.all().empty(); }

    /// The film of a photo that was tapped, with this box's number of its source. nullptr: none.
    const FilmMoment* film() const { return seen_.film ? &*seen_.film : nullptr; }

    /// The shots whose whole picture is seen, or will be, in the size of that.
    std::map<SourceId, PlacedShot> whole_pictures() const;

  private:
    LiftedMoment seen_;
    std::chrono::nanoseconds seen_at_{0};
    LiftedShots lifted_;
};

}  // namespace vitrine::player
