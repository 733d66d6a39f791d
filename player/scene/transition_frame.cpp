#include "player/scene/transition_frame.hpp"

#include "player/layout/cells/cut_cell.hpp"
#include "player/scene/crossfade.hpp"
#include "player/scene/photo_drift.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace vitrine::player {

namespace {

using Layer = std::vector<PlacedShot>;

Layer placed_shots(const std::vector<ChangingShot>& wall) {
    Layer placed;
    for (const ChangingShot& shot : wall)
        placed.push_back(shot.placed);
    return placed;
}

/// A shot whose region is shrunk towards its focus.
PlacedShot shrunk(const ChangingShot& shot, double share) {
    PlacedShot placed = shot.placed;
    const Vec2 focus = (shot.focus - placed.placement.offset) * (1 / placed.placement.scale);
    placed.shot.item.region = transformed(placed.shot.item.region, share, focus * (1 - share));
    return placed;
}

std::shared_ptr<const Cell> shared(Cell cell) {
    return std::make_shared<const Cell>(std::move(cell));
}

/// Takes the filler out of a layer. @return the gaps that it leaves, where no shot has pixels
std::vector<Polygon> taken_filler(Layer& layer) {
    std::vector<Polygon> gaps;
    for (PlacedShot& placed : layer) {
        if (placed.cell->filler.empty()) continue;
        gaps.insert(gaps.end(), placed.cell->filler.begin(), placed.cell->filler.end());
        placed.cell = shared(without_filler(*placed.cell));
    }
    return gaps;
}

/// The part of a shot on its own wall that lies in gaps of a layer. None: nothing.
std::optional<PlacedShot> piece_in(const ChangingShot& shot, const std::vector<Polygon>& gaps) {
    if (gaps.empty()) return std::nullopt;
    Cell part = inside_part(*shot.placed.cell, gaps);
    if (part.parts.empty() && part.filler.empty()) return std::nullopt;
    PlacedShot piece = shot.placed;
    piece.cell = shared(std::move(part));
    return piece;
}

/// The shots of a wall that move, and those that leave or come where they have a place. @param share  of the
/// duration
Layer layer_at(const Transition& transition, const std::vector<ChangingShot>& wall, double share,
               const CellStyle& style) {
    const std::vector<Placement> placements = placements_at(transition, share);
    Layer layer;
    for (const ChangingShot& shot : wall) {
        if (shot.moving) {
            layer.push_back(shot.placed);
            layer.back().placement = placements[*shot.moving];
            continue;
        }
        const double free = free_share(transition, shot, placements);
        if (free >= min_free_share) layer.push_back(shrunk(shot, free));
    }
    give_cells(layer, transition.canvas, style);
    return layer;
}

/// The layer of the old wall. Its gaps show what leaves. In the places that shots have left on their way they
/// show what comes, as far as that has pixels there, and else the shot that has left, which is then seen
/// twice.
Layer lower_layer(const Transition& transition, double share, const CellStyle& style) {
    Layer layer = layer_at(transition, transition.old_wall, share, style);
    const std::vector<Polygon> gaps = taken_filler(layer);
    std::vector<Polygon> left_places;
    for (const ChangingShot& shot : transition.old_wall) {
        auto piece = piece_in(shot, gaps);
        if (!piece) continue;
        const std::vector<Polygon>& parts = piece->cell->parts;
        if (shot.moving) left_places.insert(left_places.end(), parts.begin(), parts.end());
        layer.push_back(std::move(*piece));
    }
    for (const ChangingShot& shot : transition.new_wall) {
        auto piece = shot.moving ? std::nullopt : piece_in(shot, left_places);
        if (!piece || piece->cell->parts.empty()) continue;
        piece->cell = shared(without_filler(*piece->cell));
        piece->is_above = true;  // of the shot that has left
        layer.push_back(std::move(*piece));
    }
    return layer;
}

struct UpperLayer {
    Layer shots;
    bool has_gaps = false;
};

/// The layer of the new wall. Its gaps show the shots that come. Where a shot that is still on its way will
/// be, they stay open: it would be seen twice.
UpperLayer upper_layer(const Transition& transition, double share, const CellStyle& style) {
    UpperLayer layer{.shots = layer_at(transition, transition.new_wall, share, style)};
    const std::vector<Polygon> gaps = taken_filler(layer.shots);
    for (const ChangingShot& shot : transition.new_wall) {
        if (shot.moving) {
            layer.has_gaps = layer.has_gaps || piece_in(shot, gaps);
            continue;
        }
        if (auto piece = piece_in(shot, gaps)) layer.shots.push_back(std::move(*piece));
    }
    return layer;
}

/// The part of an upper layer's shot that the same shot in the lower layer does not show already. None:
/// nothing.
std::optional<PlacedShot> unseen(const PlacedShot& placed, const Layer& lower) {
    const auto same = std::ranges::find_if(lower, [&](const PlacedShot& other) {
        return other.shot.source == placed.shot.source && other.placement == placed.placement;
    });
    if (same == lower.end()) return placed;
    if (same->cell->parts == placed.cell->parts && placed.cell->filler.empty()) return std::nullopt;
    if (!placed.cell->fade_edges.empty() || !placed.cell->filler.empty()) return placed;
    PlacedShot rest = placed;
    rest.cell = shared(outside_part(*placed.cell, same->cell->parts));
    if (rest.cell->parts.empty()) return std::nullopt;
    return rest;
}

/// Where the photos of a transition are on their ways. In the first half they come back from the way on the
/// old wall, in the second half they begin the way on the new one. A photo that has the same place and cell
/// on both walls goes on.
class DriftingPhotos {
  public:
    DriftingPhotos(const Transition& transition, double share, std::chrono::nanoseconds now)
        : transition_(transition), share_(share), now_(now) {}

    /// Notes how far photos can go within these cells.
    /// @param is_first_half  true: the cells count in the first half only; false: in the second half only
    void keep_within(const Layer& layer, bool is_first_half) {
        const double weight = eased(is_first_half ? 1 - 2 * share_ : 2 * share_ - 1);
        const auto& wall = is_first_half ? transition_.old_wall : transition_.new_wall;
        for (const PlacedShot& placed : layer) {
            const ChangingShot* shot = find(wall, placed.shot.source);
            if (shot == nullptr || offsets_.contains(placed.shot.source)) continue;
            const bool goes_on = is_standing(placed.shot.source);
            if (weight <= 0 && !goes_on) continue;
            offsets_[placed.shot.source] =
                drift_within_cell(placed, shot->placed.drift, goes_on ? 1 : weight, now_);
        }
    }

    /// Moves the photos of a layer.
    void move(Layer& layer) const {
        for (PlacedShot& placed : layer) {
            placed.drift = {};
            const auto offset = offsets_.find(placed.shot.source);
            if (offset != offsets_.end()) placed.placement.offset = placed.placement.offset + offset->second;
        }
    }

  private:
    static const ChangingShot* find(const std::vector<ChangingShot>& wall, SourceId source) {
        const auto found =
            std::ranges::find(wall, source, [](const ChangingShot& shot) { return shot.placed.shot.source; });
        return found == wall.end() ? nullptr : &*found;
    }

    bool is_standing(SourceId source) const {
        const ChangingShot* before = find(transition_.old_wall, source);
        const ChangingShot* after = find(transition_.new_wall, source);
        return before != nullptr && after != nullptr && before->placed.placement == after->placed.placement &&
               before->placed.cell->parts == after->placed.cell->parts;
    }

    const Transition& transition_;  // outlives this
    double share_;
    std::chrono::nanoseconds now_;
    std::map<SourceId, Vec2> offsets_;
};

/// The share of a transition that is over. One that takes no time is over once it begins.
double share_of(std::chrono::nanoseconds duration, std::chrono::nanoseconds passed) {
    if (passed < std::chrono::nanoseconds(0)) return 0;
    if (passed >= duration) return 1;
    return std::chrono::duration<double>(passed) / std::chrono::duration<double>(duration);
}

/// The layers of a transition, the lower one first, with the photos at their places.
std::pair<Layer, Layer> drifting_layers(const Transition& transition, std::pair<Layer, Layer> layers,
                                        double share, std::chrono::nanoseconds now) {
    DriftingPhotos photos(transition, share, now);
    photos.keep_within(layers.first, true);
    photos.keep_within(layers.second, false);
    photos.move(layers.first);
    photos.move(layers.second);
    return layers;
}

}  // namespace

Frame transition_frame(const Transition& transition, std::chrono::nanoseconds passed, const CellStyle& style,
                       std::chrono::nanoseconds now) {
    const Vec2 canvas = transition.canvas;
    const double share = share_of(transition.duration, passed);
    if (transition.motion.kind == Motion::Kind::still || share <= 0 || share >= 1) {
        std::pair<Layer, Layer> layers{placed_shots(transition.old_wall), placed_shots(transition.new_wall)};
        if (share > 0 && share < 1) layers = drifting_layers(transition, std::move(layers), share, now);
        return crossfade(canvas, layers.first, layers.second, share, now);
    }
    const double fade = (share - transition.fade_begin) / (transition.fade_end - transition.fade_begin);
    const double alpha = eased(fade);
    UpperLayer upper = alpha > 0 ? upper_layer(transition, share, style) : UpperLayer{};
    const bool is_lower_seen = alpha < 1 || upper.has_gaps;
    const auto [lower, above] = drifting_layers(
        transition, {is_lower_seen ? lower_layer(transition, share, style) : Layer{}, std::move(upper.shots)},
        share, now);
    if (!is_lower_seen) return standing_frame(canvas, above, now);
    Frame frame = standing_frame(canvas, lower, now);
    if (alpha <= 0) return frame;
    Layer unseen_above;
    for (const PlacedShot& placed : above)
        if (auto rest = unseen(placed, lower)) unseen_above.push_back(std::move(*rest));
    for (DrawItem item : standing_frame(canvas, unseen_above, now).items) {
        item.alpha = std::min(alpha, max_blended);
        frame.items.push_back(std::move(item));
    }
    return frame;
}

}  // namespace vitrine::player
