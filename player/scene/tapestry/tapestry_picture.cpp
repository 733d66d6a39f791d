#include "player/scene/crossfade.hpp"
#include "player/scene/tapestry/tapestry_show.hpp"

#include <algorithm>
#include <cmath>

// What a strip looks like.

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr auto appearing = 300ms;  // that what begins to play fades in
constexpr double blend_begin =
    0.2;  // of the way from a level to the next: there the finer one begins to be seen
constexpr double blend_end = 0.8;   // there it is all that is seen
constexpr double soft_edge = 0.14;  // of the height of what plays in place
constexpr int edge_points = 6;      // a side, of the soft edge

std::vector<std::array<Vec2, 3>> triangles_of(const Box& box) {
    const Vec2 right_top{box.max.x, box.min.y};
    const Vec2 left_bottom{box.min.x, box.max.y};
    return {{box.min, right_top, box.max}, {box.min, box.max, left_bottom}};
}

/// A cell that is a box, with clean edges.
std::shared_ptr<const Cell> box_cell(const Box& box) {
    return std::make_shared<const Cell>(Cell{.parts = {to_polygon(box)},
                                             .filler = {},
                                             .triangles = triangles_of(box),
                                             .filler_triangles = {},
                                             .fade_edges = {FadeEdge{}}});
}

/// A box that fades out over what lies around it.
std::shared_ptr<const Cell> soft_cell(const Box& box, double edge) {
    const Box inner{box.min + Vec2{edge, edge}, box.max - Vec2{edge, edge}};
    const Polygon corners = to_polygon(inner);
    FadeEdge fade;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (int k = 0; k < edge_points; ++k)
            fade.outline.push_back(corners[i] + (corners[(i + 1) % corners.size()] - corners[i]) *
                                                    (static_cast<double>(k) / edge_points));
    fade.widths.assign(fade.outline.size(), edge);
    return std::make_shared<const Cell>(Cell{.parts = {corners},
                                             .filler = {},
                                             .triangles = triangles_of(inner),
                                             .filler_triangles = {},
                                             .fade_edges = {fade},
                                             .edge_coverage = 1});
}

}  // namespace

Frame TapestryShow::picture(nanoseconds now) {
    Frame frame{.canvas = canvas_, .idle = 1, .time = now};
    draw_levels(frame);
    draw_in_place(frame);
    draw_preview(frame);
    if (shown_ && shown_->began) draw_playhead(frame, *shown_);
    return frame;
}

void TapestryShow::draw_levels(Frame& frame) const {
    const auto coarse = static_cast<std::size_t>(view().level);
    const double share = view().level - static_cast<double>(coarse);
    if (share > 0 && tapestry_.levels[coarse + 1].has_zoom) {
        if (!is_whole(coarse)) draw_level(frame, 0, 1);
        if (goes_over_whole(coarse)) cover(frame);
        draw_zoom(frame, coarse, true);
        return draw_zoom(frame, coarse + 1, false);
    }
    const double alpha = eased((share - blend_begin) / (blend_end - blend_begin));
    const bool has_all = is_whole(share > 0 && alpha >= 1 ? coarse + 1 : coarse);
    if (has_all)
        cover(frame);
    else
        draw_level(frame, 0, 1);
    if (alpha < 1) draw_level(frame, coarse, 1);
    if (alpha > 0) draw_level(frame, coarse + 1, alpha);
}

const ZoomMesh* TapestryShow::zoom_of(const TileId& tile, bool is_to_finer) const {
    const auto found = zooms_.find(tile);
    if (found == zooms_.end()) return nullptr;
    return (is_to_finer ? found->second.to_finer : found->second.to_coarser).get();
}

/// A level's tiles on their way to the one next to it.
void TapestryShow::draw_zoom(Frame& frame, std::size_t level, bool is_to_finer) const {
    const double share = view().level - std::floor(view().level);
    for (const auto& [tile, middle] : place().tiles(view(), level, box_.min.x, box_.max.x)) {
        const ZoomMesh* mesh = zoom_of(tile, is_to_finer);
        if (mesh == nullptr || !cache_.has(tile)) continue;
        const Placement placement = place().zoom_placement(view(), *mesh);
        const auto canvas_x = [&](double coarse, double fine) {
            const double x =
                (1 - share) * (coarse - mesh->coarse_origin) + share * (fine - mesh->fine_origin);
            return placement.offset.x + placement.scale * x;
        };
        if (canvas_x(mesh->coarse_left, mesh->fine_left) > box_.max.x ||
            canvas_x(mesh->coarse_right, mesh->fine_right) < box_.min.x)
            continue;
        const TileZooms& zooms = zooms_.at(tile);
        const double width =
            std::min<double>(tapestry_.tile_width, tapestry_.levels[level].width -
                                                       static_cast<double>(tile.tile) * tapestry_.tile_width);
        frame.items.push_back({.source = source_of(tile),
                               .cell = {},
                               .zoom = is_to_finer ? zooms.to_finer : zooms.to_coarser,
                               .share = share,
                               .placement = placement,
                               .picture = {width, static_cast<double>(tapestry_.height)}});
    }
}

/// Whether all that is seen of a level can be drawn.
bool TapestryShow::is_whole(std::size_t level) const {
    return std::ranges::all_of(place().tiles(view(), level, box_.min.x, box_.max.x),
                               [&](const auto& tile) { return cache_.has(tile.first); });
}

/// Whether all that is seen of a level can be drawn on its way to the finer one.
bool TapestryShow::goes_over_whole(std::size_t coarse) const {
    return std::ranges::all_of(place().tiles(view(), coarse, box_.min.x, box_.max.x), [&](const auto& tile) {
        return cache_.has(tile.first) && zoom_of(tile.first, true) != nullptr;
    });
}

/// The strip is drawn whole: all of its box that the film reaches.
void TapestryShow::cover(Frame& frame) const {
    const double left = place().canvas_x(view(), 0ns);
    const double right = place().canvas_x(view(), tapestry_.duration);
    frame.covered.push_back(intersection(box_, {{left, box_.min.y}, {right, box_.max.y}}));
}

void TapestryShow::draw_level(Frame& frame, std::size_t level, double alpha) const {
    for (const TilePiece& piece : place().pieces(view(), level, box_.min.x, box_.max.x)) {
        if (!cache_.has(piece.tile)) continue;
        const double width = (piece.right - piece.left) / (piece.last - piece.first);
        frame.items.push_back(
            {.source = source_of(piece.tile),
             .cell = box_cell({{piece.left, box_.min.y}, {piece.right, box_.max.y}}),
             .placement = {.scale = 1, .offset = {piece.left - piece.first * width, box_.min.y}},
             .picture = {width, box_.height()},
             .alpha = alpha});
    }
}

void TapestryShow::draw_in_place(Frame& frame) {
    if (!in_place_ || !in_place_->began) return;
    if (in_place_->began->count() < 0) in_place_->began = frame.time;
    const nanoseconds local = frame.time - *in_place_->began;
    const Box at = brick(in_place_->begin);
    const double alpha =
        eased(std::chrono::duration<double>(local) / std::chrono::duration<double>(appearing));
    frame.items.push_back({.source = in_place_->source,
                           .cell = soft_cell(at, soft_edge * at.height()),
                           .placement = {.scale = 1, .offset = at.min},
                           .picture = {at.width(), at.height()},
                           .local = local,
                           .alpha = std::min(alpha, 0.999)});
}

void TapestryShow::draw_preview(Frame& frame) {
    if (!shown_ || !shown_->began) return;
    if (shown_->began->count() < 0) shown_->began = frame.time;
    nanoseconds local = frame.time - *shown_->began;
    if (incoming_ && incoming_->follows) local = std::min(local, shown_->length() - 1ns);  // it waits
    frame.covered.push_back(preview_);
    frame.items.push_back({.source = shown_->source,
                           .cell = box_cell(preview_),
                           .placement = {.scale = 1, .offset = preview_.min},
                           .picture = {preview_.width(), preview_.height()},
                           .local = local,
                           .alpha = 1});
}

/// A line through the strip at what plays above it.
void TapestryShow::draw_playhead(Frame& frame, const Playing& playing) const {
    const nanoseconds length = playing.end - playing.begin;
    const nanoseconds local = frame.time - *playing.began;
    const double x =
        std::round(place().canvas_x(view(), playing.begin + (length.count() > 0 ? local % length : local)));
    const double half = std::max(1.0, std::round(canvas_.y / 720));
    if (x < box_.min.x || x > box_.max.x) return;
    frame.items.push_back({.source = mark(),
                           .cell = box_cell({{x - half, box_.min.y}, {x + half, box_.max.y}}),
                           .placement = {.scale = 1, .offset = {x - half, box_.min.y}},
                           .picture = {2 * half, box_.height()},
                           .alpha = 0.85});
}

}  // namespace vitrine::player
