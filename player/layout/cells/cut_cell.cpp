#include "player/layout/cells/cut_cell.hpp"

#include "player/layout/cells/grid.hpp"
#include "player/layout/cells/triangulation.hpp"

namespace vitrine::player {

namespace {

constexpr double min_part = 1.0 / 64;  // canvas px^2; a smaller part is an error of rounding

Loops loops_of(std::span<const Polygon> outlines) {
    Loops loops;
    for (const Polygon& outline : outlines)
        loops.push_back(to_grid(outline));
    return loops;
}

void add_parts(std::vector<Polygon>& polygons, std::vector<std::array<Vec2, 3>>& triangles,
               const Loops& loops) {
    if (area_of(loops) < min_part) return;
    for (const Loop& loop : without_holes(loops)) {
        polygons.push_back(from_grid(loop));
        for (const GridTriangle& t : triangulated(loop))
            triangles.push_back({from_grid(t[0]), from_grid(t[1]), from_grid(t[2])});
    }
}

template <typename Points> void transform(Points& points, double scale, Vec2 offset) {
    for (Vec2& point : points)
        point = point * scale + offset;
}

}  // namespace

Cell inside_part(const Cell& cell, std::span<const Polygon> outlines) {
    const Loops by = loops_of(outlines);
    Cell part{.edge_coverage = cell.edge_coverage};
    add_parts(part.parts, part.triangles, intersection_of(loops_of(cell.parts), by));
    if (!cell.filler.empty())
        add_parts(part.filler, part.filler_triangles, intersection_of(loops_of(cell.filler), by));
    return part;
}

Cell outside_part(const Cell& cell, std::span<const Polygon> outlines) {
    Cell part{.edge_coverage = cell.edge_coverage};
    add_parts(part.parts, part.triangles, difference_of(loops_of(cell.parts), loops_of(outlines)));
    return part;
}

Cell without_filler(const Cell& cell) {
    Cell same = cell;
    same.filler.clear();
    same.filler_triangles.clear();
    return same;
}

Cell scaled_cell(const Cell& cell, double scale, Vec2 offset) {
    Cell same = cell;
    for (auto* outlines : {&same.parts, &same.filler})
        for (Polygon& outline : *outlines)
            transform(outline, scale, offset);
    for (auto* triangles : {&same.triangles, &same.filler_triangles})
        for (auto& triangle : *triangles)
            transform(triangle, scale, offset);
    for (FadeEdge& edge : same.fade_edges) {
        transform(edge.outline, scale, offset);
        for (double& width : edge.widths)
            width *= scale;
    }
    return same;
}

}  // namespace vitrine::player
