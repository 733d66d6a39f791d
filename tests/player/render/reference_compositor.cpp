#include "tests/player/render/reference_compositor.hpp"

#include "tests/player/render/reference_idle.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace vitrine::player {

namespace {

bool is_whole_number(double value) {
    return std::abs(value - std::round(value)) < 1e-3;
}

/// Twice the signed area of a, b and p. Exactly the opposite of the same with a and b exchanged.
double side_of(Vec2 a, Vec2 b, Vec2 p) {
    const bool is_turned = b.x < a.x || (b.x == a.x && b.y < a.y);
    if (is_turned) std::swap(a, b);
    const double side = cross(b - a, p - a);
    return is_turned ? -side : side;
}

/// True if a pixel whose centre lies on this side belongs to the triangle: of two triangles with this side,
/// exactly one says so.
bool owns_side(Vec2 from, Vec2 to) {
    return to.y > from.y || (to.y == from.y && to.x < from.x);
}

/// The shares of the three corners in a point of a triangle; none: the point is outside.
/// @param whole  twice the triangle's area
template <typename Triangle>
std::optional<std::array<double, 3>> shares_at(const Triangle& triangle, Vec2 point, double whole) {
    std::array<double, 3> shares{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 a = triangle[(k + 1) % 3].at;
        const Vec2 b = triangle[(k + 2) % 3].at;
        const double side = side_of(a, b, point);
        if (side < 0 || (side == 0 && !owns_side(a, b))) return std::nullopt;
        shares[k] = side / whole;
    }
    return shares;
}

/// True if a point lies on a side of a triangle, as exactly as GL knows: it puts corners on a grid of
/// 1/256 px, so that such a pixel may belong to none of two triangles, or to both.
template <typename Triangle> bool is_on_side(const Triangle& triangle, Vec2 point) {
    constexpr double grid = 1.0 / 256;  // px
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 from = triangle[k].at;
        const Vec2 side = triangle[(k + 1) % 3].at - from;
        const double squared = dot(side, side);
        if (squared <= 0) continue;
        const double share = std::clamp(dot(point - from, side) / squared, 0.0, 1.0);
        if (length(point - from - side * share) <= 2 * grid) return true;
    }
    return false;
}

/// A point between the corners of a triangle.
template <typename Corner>
Corner mixed(const std::array<Corner, 3>& triangle, const std::array<double, 3>& shares) {
    Corner sum{.at = {}, .place = {}, .opacity = 0, .colour = {}};
    for (std::size_t k = 0; k < 3; ++k) {
        sum.at = sum.at + triangle[k].at * shares[k];
        sum.place = sum.place + triangle[k].place * shares[k];
        sum.opacity += triangle[k].opacity * shares[k];
        for (std::size_t i = 0; i < 3; ++i)
            sum.colour[i] += triangle[k].colour[i] * shares[k];
    }
    return sum;
}

}  // namespace

Vec2 ReferenceCompositor::on_screen(Vec2 canvas_point) const {
    const Vec2 moved = canvas_point - frame_->view;
    const Vec2 share{moved.x / frame_->canvas.x, moved.y / frame_->canvas.y};
    Vec2 turned = share;
    if (view_.rotation == Rotation::right) turned = {share.y, 1 - share.x};
    if (view_.rotation == Rotation::half) turned = {1 - share.x, 1 - share.y};
    if (view_.rotation == Rotation::left) turned = {1 - share.y, share.x};
    return {view_.left + turned.x * (width_ - view_.left - view_.right),
            view_.top + turned.y * (height_ - view_.top - view_.bottom)};
}

ReferenceImage ReferenceCompositor::drawn(const Frame& frame) {
    frame_ = &frame;
    is_on_pixels_ = is_whole_number(frame.view.x) && is_whole_number(frame.view.y) &&
                    frame.canvas == canvas_size(width_, height_, view_);
    const auto count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    image_ = {.width = width_,
              .height = height_,
              .pixels = std::vector<Rgb>(count, Rgb{}),
              .blends = std::vector<std::uint16_t>(count, 0),
              .is_edge = std::vector<bool>(count, false),
              .low = std::vector<std::array<float, 3>>(count),
              .high = std::vector<std::array<float, 3>>(count)};
    draw_idle(frame);
    const std::span<const DrawItem> items = frame.items;
    for (std::size_t begin = 0, end = 0; begin < items.size(); begin = end) {
        while (end < items.size() && items[end].alpha == items[begin].alpha &&
               !items[end].zoom == !items[begin].zoom)
            ++end;
        draw_run(items.subspan(begin, end - begin));
    }
    return std::move(image_);
}

/// Draws the idle picture below everything else, opaque if a hole would be seen.
void ReferenceCompositor::draw_idle(const Frame& frame) {
    bool has_base = frame.is_fade;
    bool is_missing = false;
    for (const DrawItem& item : frame.items) {
        if (item.alpha < 1 && !frame.is_fade) continue;
        (pictures_.contains(item.source) ? has_base : is_missing) = true;
    }
    const double opacity = !has_base || is_missing ? 1 : frame.idle;
    if (opacity <= 0) return;
    const auto place = [&](Vec2 share) {
        return on_screen(Vec2{share.x * frame.canvas.x, share.y * frame.canvas.y} + frame.view);
    };
    for (const auto& triangle : idle_triangles(frame.canvas, frame.time)) {
        Triangle corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = {.at = place(triangle[i].share),
                          .place = {},
                          .opacity = opacity,
                          .colour = triangle[i].colour};
        draw_triangle(corners, [](const Corner& at) { return at.colour; });
    }
}

void ReferenceCompositor::draw_run(std::span<const DrawItem> items) {
    if (items.front().zoom) {
        for (const DrawItem& item : items)
            if (pictures_.contains(item.source)) draw_zoom(item);
        return;
    }
    for (const DrawItem& item : items)
        if (pictures_.contains(item.source) && item.alpha > 0) draw_fills(item);
    for (const DrawItem& item : items)
        if (pictures_.contains(item.source) && item.alpha > 0) draw_fringes(item);
}

ReferenceCompositor::Corner ReferenceCompositor::corner(const DrawItem& item, Vec2 canvas_point,
                                                        double opacity) const {
    const Vec2 source = (canvas_point - item.placement.offset) * (1 / item.placement.scale) +
                        pictures_.at(item.source).slide() * item.slide_share;
    return {.at = on_screen(canvas_point),
            .place = {source.x / item.picture.x, source.y / item.picture.y},
            .opacity = opacity,
            .colour = {}};
}

/// Chooses how the item's picture is sampled.
ReferenceCompositor::Shade ReferenceCompositor::shade_of(const DrawItem& item, bool is_filler) {
    ReferencePicture& picture = pictures_.at(item.source);
    if (is_filler) {
        picture.make_smaller_copies();
        Box active = item.active.is_empty() ? Box{{0, 0}, item.picture} : item.active;
        for (Vec2* corner : {&active.min, &active.max})
            *corner = {corner->x / item.picture.x, corner->y / item.picture.y};
        return [&picture, active, light = item.filler_light](const Corner& at) {
            return picture.filler_at(at.place, active, light);
        };
    }
    const Vec2 across = on_screen({1, 0}) - on_screen({0, 0});
    const Vec2 down = on_screen({0, 1}) - on_screen({0, 0});
    picture.aim(item, {length(across), length(down)}, is_on_pixels_);
    if (!picture.is_exact()) return [&picture](const Corner& at) { return picture.at(at.place); };
    const Vec2 offset = item.placement.offset;
    const Vec2 shown = item.picture * item.placement.scale;
    return [&picture, offset, shown](const Corner& at) {  // moved to whole pixels
        const Vec2 point{at.place.x * shown.x + offset.x, at.place.y * shown.y + offset.y};
        return picture.at({(point.x - std::round(offset.x)) / picture.width(),
                           (point.y - std::round(offset.y)) / picture.height()});
    };
}

void ReferenceCompositor::draw_fills(const DrawItem& item) {
    const double opacity = std::min(1.0, item.alpha);
    const auto draw = [&](const std::vector<std::array<Vec2, 3>>& triangles, bool is_filler) {
        if (triangles.empty()) return;
        const Shade shade = shade_of(item, is_filler);
        for (const auto& t : triangles)
            draw_triangle(
                {corner(item, t[0], opacity), corner(item, t[1], opacity), corner(item, t[2], opacity)},
                shade);
    };
    draw(item.cell->filler_triangles, true);
    draw(item.cell->triangles, false);
    mark_outlines(item.cell->filler);
    mark_outlines(item.cell->parts);
}

void ReferenceCompositor::draw_fringes(const DrawItem& item) {
    constexpr double half = 0.5;
    const auto narrow = [&](const std::vector<Polygon>& outlines, double coverage, bool is_filler) {
        if (outlines.empty()) return;
        const Shade shade = shade_of(item, is_filler);
        for (const Polygon& outline : outlines)
            draw_fringe(item, {outline, std::vector<double>(outline.size(), 1)}, coverage, shade);
    };
    narrow(item.cell->filler, half, true);
    if (item.cell->fade_edges.empty()) return narrow(item.cell->parts, item.cell->edge_coverage, false);
    const Shade shade = shade_of(item, false);
    for (const FadeEdge& edge : item.cell->fade_edges)
        draw_fringe(item, edge, item.cell->edge_coverage, shade);
}

/// Draws the strip outside an outline whose opacity falls from `coverage` to nothing.
void ReferenceCompositor::draw_fringe(const DrawItem& item, const FadeEdge& edge, double coverage,
                                      const Shade& shade) {
    constexpr double same_place = 1e-5;  // canvas px; of nearer corners the renderer makes one
    const double inner = std::min(1.0, item.alpha) * coverage;
    Vec2 before{};
    for (std::size_t k = 0; k < edge.outline.size(); ++k) {
        const std::size_t next = (k + 1) % edge.outline.size();
        if (edge.outline[k] == edge.outline[next]) continue;
        const Vec2 side = edge.outline[next] - edge.outline[k];
        const Vec2 outward = Vec2{side.y, -side.x} * (1 / length(side));
        const Corner from = corner(item, edge.outline[k], inner);
        const Corner to = corner(item, edge.outline[next], inner);
        const Corner far_to = corner(item, edge.outline[next] + outward * edge.widths[next], 0);
        const Corner far_from = corner(item, edge.outline[k] + outward * edge.widths[k], 0);
        draw_triangle({from, to, far_to}, shade);
        draw_triangle({from, far_to, far_from}, shade);
        mark_edge(far_from.at, far_to.at);
        const Vec2 turned = (outward - before) * edge.widths[k];
        if (length(turned) > same_place) {  // where the outline turns, two strips overlap or leave a gap
            mark_edge(from.at, far_from.at);
            mark_edge(from.at, on_screen(edge.outline[k] + before * edge.widths[k]));
        }
        if (next == 0) mark_edge(to.at, far_to.at);
        before = outward;
    }
}

void ReferenceCompositor::draw_zoom(const DrawItem& item) {
    const ZoomMesh& mesh = *item.zoom;
    const bool is_opaque = mesh.is_whole && item.alpha >= 1;
    const Shade shade = shade_of(item, false);
    std::vector<Corner> corners;
    for (const ZoomMesh::Vertex& v : mesh.vertices) {
        const Vec2 strip{v.coarse_x * (1 - item.share) + v.fine_x * item.share,
                         v.coarse_y * (1 - item.share) + v.fine_y * item.share};
        const double coverage = v.growth < 0 ? 1 : item.share / (v.growth * (1 - item.share) + item.share);
        corners.push_back({.at = on_screen(item.placement.offset + strip * item.placement.scale),
                           .place = {v.u, v.v},
                           .opacity = is_opaque ? 1 : item.alpha * coverage,
                           .colour = {}});
    }
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        const Triangle triangle{corners[mesh.triangles[i]], corners[mesh.triangles[i + 1]],
                                corners[mesh.triangles[i + 2]]};
        draw_triangle(triangle, shade);
        for (std::size_t k = 0; k < 3; ++k)
            mark_edge(triangle[k].at, triangle[(k + 1) % 3].at);
    }
}

void ReferenceCompositor::draw_triangle(Triangle triangle, const Shade& shade) {
    if (side_of(triangle[0].at, triangle[1].at, triangle[2].at) < 0) std::swap(triangle[1], triangle[2]);
    double top = triangle[0].at.y;
    double bottom = top;
    for (const Corner& corner : triangle) {
        top = std::min(top, corner.at.y);
        bottom = std::max(bottom, corner.at.y);
    }
    const int first = std::max(view_.top, static_cast<int>(std::floor(top)));
    const int last = std::min(height_ - view_.bottom - 1, static_cast<int>(std::ceil(bottom)));
    for (int y = first; y <= last; ++y)
        draw_row(triangle, y, shade);
}

/// Draws the pixels of a row whose centres lie in the triangle.
void ReferenceCompositor::draw_row(const Triangle& triangle, int y, const Shade& shade) {
    double left = width_;
    double right = 0;
    for (std::size_t k = 0; k < 3; ++k) {  // where the sides cross the row of the pixels' centres
        const Vec2 a = triangle[k].at;
        const Vec2 b = triangle[(k + 1) % 3].at;
        const double place = y + 0.5;
        if (std::min(a.y, b.y) > place || std::max(a.y, b.y) < place) continue;
        const double share = a.y == b.y ? 0 : (place - a.y) / (b.y - a.y);
        for (const double x : {a.x + (b.x - a.x) * share, a.y == b.y ? b.x : a.x + (b.x - a.x) * share}) {
            left = std::min(left, x);
            right = std::max(right, x);
        }
    }
    const double whole = side_of(triangle[0].at, triangle[1].at, triangle[2].at);
    const int first = std::max(view_.left, static_cast<int>(std::floor(left)) - 1);
    const int last = std::min(width_ - view_.right - 1, static_cast<int>(std::ceil(right)) + 1);
    for (int x = first; x <= last && whole > 0; ++x) {
        if (is_on_side(triangle, {x + 0.5, y + 0.5})) image_.is_edge[image_.index(x, y)] = true;
        if (const auto shares = shares_at(triangle, {x + 0.5, y + 0.5}, whole)) {
            const Corner at = mixed(triangle, *shares);
            blend(x, y, shade(at), at.opacity);
        }
    }
}

void ReferenceCompositor::blend(int x, int y, const Rgb& colour, double opacity) {
    const std::size_t index = image_.index(x, y);
    Rgb& pixel = image_.pixels[index];
    if (opacity >= 1)
        image_.blends[index] = 0;
    else if (opacity > 0)
        ++image_.blends[index];
    for (std::size_t i = 0; i < 3; ++i) {
        const double own = std::clamp(colour[i], 0.0, 1.0);
        pixel[i] = std::round((own * opacity + pixel[i] * (1 - opacity)) * 255) / 255;
        float& low = image_.low[index][i];
        float& high = image_.high[index][i];
        if (opacity >= 1) low = high = static_cast<float>(own);
        low = std::min({low, static_cast<float>(own), static_cast<float>(pixel[i])});
        high = std::max({high, static_cast<float>(own), static_cast<float>(pixel[i])});
    }
}

void ReferenceCompositor::mark_outlines(std::span<const Polygon> outlines) {
    for (const Polygon& outline : outlines)
        for (std::size_t k = 0; k < outline.size(); ++k)
            mark_edge(on_screen(outline[k]), on_screen(outline[(k + 1) % outline.size()]));
}

void ReferenceCompositor::mark_edge(Vec2 from, Vec2 to) {
    const int steps = std::max(1, static_cast<int>(std::ceil(length(to - from) * 2)));
    for (int k = 0; k <= steps; ++k) {
        const Vec2 p = from + (to - from) * (static_cast<double>(k) / steps);
        const int column = static_cast<int>(std::floor(p.x));
        const int row = static_cast<int>(std::floor(p.y));
        for (int y = std::max(0, row - 1); y <= std::min(height_ - 1, row + 1); ++y)
            for (int x = std::max(0, column - 1); x <= std::min(width_ - 1, column + 1); ++x)
                image_.is_edge[image_.index(x, y)] = true;
    }
}

}  // namespace vitrine::player
