#include "player/scene/acts/led_panning_wall.hpp"

#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double told_exactly = 0.1;  // px by which the view may be elsewhere than it was told
constexpr auto same_time = std::chrono::milliseconds(1);

/// True if a follower that knows the told shot shows the shot as it is now.
bool is_same(const PlacedShot& told, const PlacedShot& shot) {
    const bool began_then = told.began == shot.began || shot.began == never ||
                            (told.began != never && std::chrono::abs(told.began - shot.began) < same_time);
    return told.shot.source == shot.shot.source && told.cell == shot.cell &&
           told.shot.shot.stored == shot.shot.shot.stored && began_then;
}

std::vector<PlacedShot> copied(const std::vector<const PlacedShot*>& lent) {
    std::vector<PlacedShot> shots;
    shots.reserve(lent.size());
    for (const PlacedShot* const placed : lent)
        shots.push_back(*placed);
    return shots;
}

/// The shots, each that will come into the view with the time at which it does.
std::vector<PlacedShot> with_begins(const PanParts& parts, Vec2 canvas) {
    std::vector<PlacedShot> shots = copied(parts.shots);
    if (parts.course.speed <= 0) return shots;
    for (PlacedShot& placed : shots)
        if (placed.began == never)
            placed.began = parts.course.time_of(bounds_of(*placed.cell).min.x + parts.origin - canvas.x);
    return shots;
}

}  // namespace

void LedPanningWall::set_canvas(const Canvas& canvas) {
    canvas_ = canvas;
    wall_.set_canvas(canvas);
}

/// Tells of the shots that come, once each.
void LedPanningWall::prepare_coming(const PanParts& parts) {
    const bool is_new = std::ranges::any_of(
        parts.coming, [&](const PlacedShot* placed) { return !prepared_.contains(placed->shot.source); });
    if (!is_new) return;
    prepared_.clear();
    for (const PlacedShot* const placed : parts.coming)
        prepared_.insert(placed->shot.source);
    prepare(copied(parts.coming), canvas_, cells_);
}

/// True if the others know all of the wall from the last act, or must not be told of it yet.
bool LedPanningWall::is_told(const PanParts& parts) const {
    if (parts.shots.empty() && (parts.has_files || !told_)) return true;
    if (wants_act() || !told_ || parts.shots.empty() != told_->shown.empty()) return false;
    for (const PlacedShot* const shot : parts.shots) {
        const PlacedShot* const told = find_source(told_->shown, shot->shot.source);
        if (told == nullptr || !is_same(*told, *shot)) return false;
    }
    const PanCourse& course = told_->pan->course;
    return parts.is_in_hand || (course.speed == parts.course.speed &&
                                std::abs(course.at(now()) - parts.course.view) < told_exactly);
}

void LedPanningWall::make_news() {
    const PanParts parts = wall_.parts();
    prepare_coming(parts);
    if (is_told(parts)) return;
    told_ = WallAct{.canvas = canvas_,
                    .cells = cells_,
                    .shown = with_begins(parts, canvas_),
                    .pan = ActPan{.origin = parts.origin, .course = parts.course}};
    tell(*told_);
}

LiftedMoment LedPanningWall::lifted() const {
    const PanParts parts = wall_.parts();
    LiftedMoment lifted = parts.lifted.moment(now());
    if (parts.is_in_hand) lifted.view = parts.course.view;
    return lifted;
}

}  // namespace vitrine::player
