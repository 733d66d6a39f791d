#include "player/layout/cells/grid.hpp"

#include <clipper.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace clipper = ClipperLib;

namespace {

clipper::Path to_path(const Loop& loop) {
    clipper::Path path;
    path.reserve(loop.size());
    for (const CellPoint& p : loop)
        path.emplace_back(p.x, p.y);
    return path;
}

clipper::Paths to_paths(const Loops& loops) {
    clipper::Paths paths;
    for (const Loop& loop : loops)
        paths.push_back(to_path(loop));
    return paths;
}

Loop to_loop(const clipper::Path& path) {
    Loop loop;
    loop.reserve(path.size());
    for (const clipper::IntPoint& p : path)
        loop.push_back({p.X, p.Y});
    return loop;
}

Loops to_loops(const clipper::Paths& paths) {
    Loops loops;
    for (const clipper::Path& path : paths)
        loops.push_back(to_loop(path));
    return loops;
}

Loops combined(clipper::ClipType type, const Loops& a, const Loops& b) {
    clipper::Clipper engine;
    engine.StrictlySimple(true);
    engine.AddPaths(to_paths(a), clipper::ptSubject, true);
    engine.AddPaths(to_paths(b), clipper::ptClip, true);
    clipper::Paths result;
    engine.Execute(type, result, clipper::pftNonZero, clipper::pftNonZero);
    return to_loops(result);
}

struct GridBox {
    std::int64_t left = 0, top = 0, right = 0, bottom = 0;
};

GridBox box_of(const Loops& loops) {
    GridBox box{loops[0][0].x, loops[0][0].y, loops[0][0].x, loops[0][0].y};
    for (const Loop& loop : loops)
        for (const CellPoint& p : loop)
            box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x),
                   std::max(box.bottom, p.y)};
    return box;
}

/// True if the boxes of two areas have no inner point in common.
bool are_apart(const Loops& a, const Loops& b) {
    const auto has_points = [](const Loops& loops) {
        return !loops.empty() && std::ranges::none_of(loops, &Loop::empty);
    };
    if (!has_points(a) || !has_points(b)) return false;
    const GridBox box = box_of(a);
    const GridBox other = box_of(b);
    return box.right <= other.left || other.right <= box.left || box.bottom <= other.top ||
           other.bottom <= box.top;
}

Loop to_loop(const GridBox& box) {
    return {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}};
}

}  // namespace

CellPoint to_grid(Vec2 point) {
    return {std::llround(point.x * cell_grid), std::llround(point.y * cell_grid)};
}

Vec2 from_grid(CellPoint point) {
    return {static_cast<double>(point.x) / cell_grid, static_cast<double>(point.y) / cell_grid};
}

Loop to_grid(const Polygon& polygon) {
    Loop loop;
    for (const Vec2& p : polygon) {
        const CellPoint point = to_grid(p);
        if (loop.empty() || loop.back() != point) loop.push_back(point);
    }
    while (loop.size() > 1 && loop.front() == loop.back())
        loop.pop_back();
    return loop;
}

Polygon from_grid(const Loop& loop) {
    Polygon polygon;
    for (const CellPoint& p : loop)
        polygon.push_back(from_grid(p));
    return polygon;
}

std::int64_t turn(CellPoint a, CellPoint b, CellPoint c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double twice_area(const Loop& loop) {
    std::int64_t sum = 0;  // terms are below 2^61 and cancel; relative to the first corner
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        sum += (loop[i].x - loop[0].x) * (loop[i + 1].y - loop[0].y) -
               (loop[i].y - loop[0].y) * (loop[i + 1].x - loop[0].x);
    return static_cast<double>(sum);
}

double area_of(const Loops& loops) {
    double twice = 0;
    for (const Loop& loop : loops)
        twice += twice_area(loop);
    return twice / (2 * cell_grid * cell_grid);
}

Loops intersection_of(const Loops& a, const Loops& b) {
    if (are_apart(a, b)) return {};
    return combined(clipper::ctIntersection, a, b);
}

Loops difference_of(const Loops& a, const Loops& b) {
    return combined(clipper::ctDifference, a, b);
}

Loops union_of(const Loops& a, const Loops& b) {
    return combined(clipper::ctUnion, a, b);
}

Loops grown(const Loops& loops, double distance) {
    constexpr double arc_tolerance = 0.1 * cell_grid;
    clipper::ClipperOffset offset(2, arc_tolerance);
    offset.AddPaths(to_paths(loops), clipper::jtRound, clipper::etClosedPolygon);
    clipper::Paths result;
    offset.Execute(result, distance * cell_grid);
    return to_loops(result);
}

Loops without_holes(const Loops& loops) {
    const auto hole =
        std::find_if(loops.begin(), loops.end(), [](const Loop& loop) { return twice_area(loop) < 0; });
    if (hole == loops.end()) return loops;
    const GridBox inner = box_of({*hole});
    const std::int64_t middle = (inner.left + inner.right) / 2;
    GridBox left = box_of(loops);
    GridBox right = left;
    left.right = right.left = middle;
    Loops result = without_holes(intersection_of(loops, {to_loop(left)}));
    const Loops others = without_holes(intersection_of(loops, {to_loop(right)}));
    result.insert(result.end(), others.begin(), others.end());
    return result;
}

}  // namespace vitrine::player
