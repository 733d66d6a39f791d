#include "player/scene/enlargement.hpp"

#include "player/layout/edit/edit.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double max_growth = 2.5;     // factor of the scale
constexpr double wished_share = 0.62;  // share of the canvas' width or height for the I-Region
constexpr double softness = 2;  // times the largest scale on the wall, because somebody looks at the shot

std::vector<SourceId> sources_of(std::span<const PlacedShot> wall) {
    std::vector<SourceId> sources;
    for (const PlacedShot& placed : wall)
        sources.push_back(placed.shot.source);
    return sources;
}

std::vector<Placement> placements_of(std::span<const PlacedShot> wall) {
    std::vector<Placement> placements;
    for (const PlacedShot& placed : wall)
        placements.push_back(placed.placement);
    return placements;
}

}  // namespace

void Enlargement::toggle(SourceId source) {
    wish_ = large_ == source || wish_ == source ? 0 : source;
    is_held_ = false;
}

void Enlargement::hold(SourceId source) {
    wish_ = source;
    is_held_ = true;
}

std::optional<std::vector<Placement>>
Enlargement::next_placements(std::span<const PlacedShot> wall, Vec2 canvas, std::chrono::nanoseconds now) {
    if (large_ != 0 && sources_ != sources_of(wall)) wish_ = large_ = 0;  // the old places are not valid
    if (large_ != 0 && !is_held_ && now - since_ >= patience_) wish_ = 0;
    if (wish_ == large_) return std::nullopt;
    if (large_ != 0) return go_back();
    since_ = now;
    return enlarge(wall, canvas);
}

std::vector<Placement> Enlargement::go_back() {
    large_ = 0;
    return std::exchange(before_, {});
}

std::optional<std::vector<Placement>> Enlargement::enlarge(std::span<const PlacedShot> wall, Vec2 canvas) {
    sources_ = sources_of(wall);
    const auto found = std::find(sources_.begin(), sources_.end(), wish_);
    if (found == sources_.end()) {
        wish_ = 0;
        return std::nullopt;
    }
    const auto item = static_cast<std::size_t>(found - sources_.begin());
    WallState standing{.canvas = canvas};
    standing.placements = standing.homes = before_ = placements_of(wall);
    for (const PlacedShot& placed : wall)
        standing.items.push_back(placed.shot.item);
    standing.pinned.assign(wall.size(), false);
    const Polygon region = placed_region(wall[item].shot.item, wall[item].placement);
    const Box box = bounding_box(region);
    const double growth =
        std::clamp(wished_share * std::min(canvas.x / box.width(), canvas.y / box.height()), 1.0, max_growth);
    EditRules rules = rules_;
    rules.max_scale *= softness;
    large_ = wish_;
    return resized(standing, item, growth, rules).placements;
}

}  // namespace vitrine::player
