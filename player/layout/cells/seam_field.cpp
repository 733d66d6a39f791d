#include "player/layout/cells/seam_field.hpp"

#include <algorithm>
#include <array>

namespace vitrine::player {

namespace {

/// True if two stretches have a point in common.
bool do_meet(CellPoint a, CellPoint b, CellPoint c, CellPoint d) {
    if (!Extent(std::array{a, b}).meets(Extent(std::array{c, d}))) return false;
    return sign_of(turn(a, b, c)) * sign_of(turn(a, b, d)) <= 0 &&
           sign_of(turn(c, d, a)) * sign_of(turn(c, d, b)) <= 0;
}

/// True if a seam that passes through a bend goes on inside its angle.
bool is_facing(const Bend& bend, const Loop& line, std::size_t i) {
    return (i > 0 && bend.faces(line[i - 1])) || (i + 1 < line.size() && bend.faces(line[i + 1]));
}

}  // namespace

Extent::Extent(std::span<const CellPoint> points)
    : left(points[0].x), top(points[0].y), right(points[0].x), bottom(points[0].y) {
    for (const CellPoint p : points) {
        left = std::min(left, p.x);
        top = std::min(top, p.y);
        right = std::max(right, p.x);
        bottom = std::max(bottom, p.y);
    }
}

Bend::Bend(CellPoint a, CellPoint p, CellPoint b)
    : before(a), at(p), after(b), side(sign_of(turn(a, p, b))), extent(std::array{a, p, b}) {}

bool Bend::has(CellPoint c) const {
    if (side == 0) return extent.has(c) && turn(before, at, c) == 0 && turn(at, after, c) == 0;
    return extent.has(c) && touches(c) && side * turn(after, before, c) >= 0;
}

bool Bend::faces(CellPoint c) const {
    return side * turn(before, at, c) > 0 && side * turn(at, after, c) > 0;
}

bool Bend::touches(CellPoint c) const {
    return side * turn(before, at, c) >= 0 && side * turn(at, after, c) >= 0;
}

int sign_of(std::int64_t value) {
    return (value > 0) - (value < 0);
}

double distance_between(CellPoint a, CellPoint b) {
    return length(from_grid(b) - from_grid(a));
}

SeamField::SeamField(std::vector<Seam>& seams, const SeamLimits& limits) : seams_(seams), limits_(limits) {
    for (const Seam& seam : seams_)
        extents_.emplace_back(seam.line);
}

void SeamField::replace(std::size_t k, Loop line) {
    seams_[k].line = std::move(line);
    extents_[k] = Extent(seams_[k].line);
}

bool SeamField::is_movable(std::size_t k) const {
    const Seam& seam = seams_[k];
    if (seam.right == no_owner || seam.line.front() == seam.line.back()) return false;
    return is_item(seam.left) == is_item(seam.right);
}

const Loop* SeamField::outline_of(std::size_t owner) const {
    if (!is_item(owner)) return nullptr;
    const Loop& reserve = limits_.reserves.empty() ? limits_.regions[owner] : limits_.reserves[owner];
    return reserve.size() < 3 ? nullptr : &reserve;
}

bool SeamField::has_pixels(std::size_t owner, CellPoint point) const {
    if (owner == no_owner || !is_item(owner)) return true;
    const auto is_in = [&](const Loop& box) { return Extent(box).has(point); };
    return std::ranges::any_of(limits_.cores[owner], is_in);
}

bool SeamField::is_crowded(const Bend& bend, std::size_t k, std::size_t at) const {
    for (std::size_t other = 0; other < seams_.size(); ++other) {
        if (!extents_[other].meets(bend.extent)) continue;
        const Loop& line = seams_[other].line;
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (other == k && i + 1 >= at && i <= at + 1) continue;
            if (line[i] == bend.before || line[i] == bend.after) continue;
            if (line[i] == bend.at ? is_facing(bend, line, i) : bend.has(line[i])) return true;
        }
    }
    return false;
}

std::optional<Loop> SeamField::corners_in(const Bend& bend, const Seam& seam) const {
    Loop corners;
    for (const std::size_t owner : {seam.left, seam.right}) {
        const Loop* outline = outline_of(owner);
        for (std::size_t i = 0; outline != nullptr && i < outline->size(); ++i) {
            const CellPoint c = (*outline)[i];
            if (c == bend.before || c == bend.after) continue;
            if (c == bend.at) {
                const std::size_t count = outline->size();
                if (bend.touches((*outline)[(i + 1) % count]) &&
                    bend.touches((*outline)[(i + count - 1) % count]))
                    return std::nullopt;
            } else if (bend.has(c) && turn(bend.before, bend.after, c) != 0) {
                corners.push_back(c);
            }
        }
    }
    return corners;
}

bool SeamField::is_crossed(CellPoint from, CellPoint to, std::span<const std::size_t> owners) const {
    const Extent extent(std::array{from, to});
    const auto meets = [&](CellPoint a, CellPoint b) {
        return a != from && b != from && a != to && b != to && do_meet(from, to, a, b);
    };
    for (std::size_t k = 0; k < seams_.size(); ++k) {
        if (!extents_[k].meets(extent)) continue;
        const Loop& line = seams_[k].line;
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            if (meets(line[i], line[i + 1])) return true;
    }
    for (const std::size_t owner : owners) {
        const Loop* outline = outline_of(owner);
        for (std::size_t i = 0; outline != nullptr && i < outline->size(); ++i)
            if (meets((*outline)[i], (*outline)[(i + 1) % outline->size()])) return true;
    }
    return false;
}

bool SeamField::is_occupied(const Bend& triangle, std::span<const std::size_t> owners) const {
    const auto occupies = [&](CellPoint c) {
        return c != triangle.before && c != triangle.at && c != triangle.after && triangle.has(c);
    };
    for (std::size_t k = 0; k < seams_.size(); ++k)
        if (extents_[k].meets(triangle.extent) && std::ranges::any_of(seams_[k].line, occupies)) return true;
    return std::ranges::any_of(owners, [&](std::size_t owner) {
        const Loop* outline = outline_of(owner);
        return outline != nullptr && std::ranges::any_of(*outline, occupies);
    });
}

}  // namespace vitrine::player
