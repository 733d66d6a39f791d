#pragma once

#include "player/scene/lifted_shots.hpp"
#include "player/scene/tapestry/tapestry_moment.hpp"

#include <chrono>
#include <map>
#include <optional>
#include <span>

namespace vitrine::player {

/// Draws, on a box that follows, the shots that hands hold above the leader's wall and the film of a photo,
/// and knows the tapestry that they have opened. Without news the shots go back after three seconds, and the
/// wall comes back after ten.
class FollowedLifted {
  public:
    /// Sets the canvas of the act that is drawn from now on, whose parts this box knows.
    void set_canvas(Vec2 canvas);

    /// Takes what the leader has drawn last.
    /// @param tapestry  in this box's time. On a canvas whose act has not come yet, it goes on where it is
    /// @param now       of this box
    void take(LiftedMoment seen, std::optional<TapestryMoment> tapestry, std::chrono::nanoseconds now);

    /// Draws the shots above a wall, and the film of a photo. @param frame  of the wall, in the leader's time
    /// @param wall            the shots are lifted off this
    /// @param is_film_ready   false: the film is not drawn
    /// @param now             of this box
    void draw(Frame& frame, std::span<const PlacedShot> wall, bool is_film_ready,
              std::chrono::nanoseconds now);

    bool is_empty() const { return lifted_.all().empty(); }

    /// The film of a photo that was tapped, with this box's number of its source. nullptr: none.
    const FilmMoment* film() const { return seen_.film ? &*seen_.film : nullptr; }

    /// The tapestry in place of the wall, in this box's time. nullptr: none on a canvas that this box knows.
    /// @param now  of this box
    const TapestryMoment* tapestry(std::chrono::nanoseconds now) const;

    /// The shots whose whole picture is seen, or will be, in the size of that.
    std::map<SourceId, PlacedShot> whole_pictures() const;

  private:
    bool knows(Vec2 canvas) const { return canvas == canvas_ || canvas == canvas_before_; }

    Vec2 canvas_;         // of the act that is drawn
    Vec2 canvas_before_;  // of acts before
    LiftedMoment seen_;
    std::optional<TapestryMoment> tapestry_;
    std::chrono::nanoseconds seen_at_{0};  // when the last news came
    LiftedShots lifted_;
};

}  // namespace vitrine::player
