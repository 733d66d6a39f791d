#include "player/layout/cells/seam_bends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace vitrine::player {

namespace {

/// The point where two bends of the same turn would be one, so near that nobody sees it. None: there is none.
std::optional<CellPoint> common_bend(const SeamField& field, std::size_t k, std::size_t at) {
    constexpr double max_depth = 4;  // canvas px from the stretch between the bends
    const Loop& line = field.seam(k).line;
    const CellPoint before = line[at - 1];
    const CellPoint one = line[at];
    const CellPoint other = line[at + 1];
    const CellPoint after = line[at + 2];
    const int side = sign_of(turn(before, one, other));
    if (side == 0 || side != sign_of(turn(one, other, after))) return std::nullopt;
    const Vec2 in = from_grid(one) - from_grid(before);
    const Vec2 out = from_grid(other) - from_grid(after);
    const Vec2 between = from_grid(other) - from_grid(one);
    const double crossing = cross(in, out);
    if (crossing * side >= 0) return std::nullopt;
    const Vec2 way = in * (cross(between, out) / crossing);
    const double depth = std::abs(cross(between, way)) / length(between);
    if (depth > max_depth) return std::nullopt;
    const Vec2 away = Vec2{between.y, -between.x} * (side / length(between));
    for (const double grid_steps : {0.0, 2.0, 6.0}) {
        const CellPoint bend = to_grid(from_grid(one) + way + away * (grid_steps / cell_grid));
        const std::array owners{field.seam(k).left, field.seam(k).right};
        const bool is_outside = side * turn(before, bend, one) >= 0 && side * turn(bend, after, other) >= 0;
        if (is_outside && field.has_pixels(owners[0], bend) && field.has_pixels(owners[1], bend) &&
            !field.is_occupied(Bend(one, bend, other), owners) && !field.is_crossed(one, bend, owners) &&
            !field.is_crossed(bend, other, owners))
            return bend;
    }
    return std::nullopt;
}

/// The arc in place of a bend. @param reach  canvas px from the bend to the arc's ends
Loop arc_of(const Bend& bend, double reach) {
    constexpr double tolerance = 0.1;  // canvas px between the arc and its chords
    const Vec2 at = from_grid(bend.at);
    const Vec2 in = at - from_grid(bend.before);
    const Vec2 out = from_grid(bend.after) - at;
    const Vec2 along = in * (1 / length(in));
    const Vec2 inward = Vec2{-along.y, along.x} * bend.side;
    const double angle = std::atan2(std::abs(cross(in, out)), dot(in, out));
    const double radius = reach / std::tan(angle / 2);
    const double step = 2 * std::acos(std::max(0.0, 1 - tolerance / radius));
    const int pieces = std::clamp(static_cast<int>(std::ceil(angle / step)), 1, 64);
    Loop arc;
    for (int i = 0; i <= pieces; ++i) {
        const double turned = angle * i / pieces;
        arc.push_back(to_grid(at - along * reach + along * (radius * std::sin(turned)) +
                              inward * (radius * (1 - std::cos(turned)))));
    }
    return arc;
}

/// True if an arc in place of a bend cuts off a corner of a region.
bool cuts(const Loop& arc, const Bend& bend, const Loop& region) {
    const Bend corner(arc.front(), bend.at, arc.back());
    return std::ranges::any_of(region, [&](CellPoint c) {
        if (!corner.has(c)) return false;
        for (std::size_t i = 0; i + 1 < arc.size(); ++i)
            if (bend.side * turn(arc[i], arc[i + 1], c) < 0) return true;
        return false;
    });
}

/// The rounded form of one bend: the bend itself if there is no room for an arc.
Loop rounded_bend(const SeamField& field, const SeamLimits& limits, std::size_t k, std::size_t at,
                  double radius) {
    const Seam& seam = field.seam(k);
    const Bend bend(seam.line[at - 1], seam.line[at], seam.line[at + 1]);
    if (bend.side == 0) return {bend.at};
    const Vec2 in = from_grid(bend.at) - from_grid(bend.before);
    const Vec2 out = from_grid(bend.after) - from_grid(bend.at);
    const double angle = std::atan2(std::abs(cross(in, out)), dot(in, out));
    constexpr double half = 0.49;  // of a stretch; the other half is for the next bend
    double reach = std::min({radius * std::tan(angle / 2), half * length(in), half * length(out)});
    for (int tries = 0; tries < 8 && reach * std::tan(angle / 4) > 1.0 / 16; ++tries, reach /= 1.5) {
        Loop arc = arc_of(bend, reach);
        const auto cuts_region = [&](std::size_t owner) {
            return field.is_item(owner) && cuts(arc, bend, limits.regions[owner]);
        };
        if (!cuts_region(seam.left) && !cuts_region(seam.right) &&
            !field.is_crowded(Bend(arc.front(), bend.at, arc.back()), k, at))
            return arc;
    }
    return {bend.at};
}

}  // namespace

void join_bends(SeamField& field, std::size_t k) {
    for (std::size_t at = 1; at + 2 < field.seam(k).line.size();) {
        const auto bend = common_bend(field, k, at);
        if (!bend) {
            ++at;
            continue;
        }
        Loop line = field.seam(k).line;
        line[at] = *bend;
        line.erase(line.begin() + static_cast<std::ptrdiff_t>(at) + 1);
        field.replace(k, std::move(line));
    }
}

void round_bends(std::vector<Seam>& seams, const SeamLimits& limits, double radius) {
    const SeamField field(seams, limits);
    std::vector<Loop> lines;
    for (std::size_t k = 0; k < seams.size(); ++k) {
        const Loop& line = seams[k].line;
        lines.push_back(line);
        if (!field.is_movable(k)) continue;
        lines.back() = {line.front()};
        for (std::size_t at = 1; at + 1 < line.size(); ++at) {
            const Loop rounded = rounded_bend(field, limits, k, at, radius);
            lines.back().insert(lines.back().end(), rounded.begin(), rounded.end());
        }
        lines.back().push_back(line.back());
    }
    for (std::size_t k = 0; k < seams.size(); ++k)
        seams[k].line = std::move(lines[k]);
}

}  // namespace vitrine::player
