#include "player/render/cell_mesh.hpp"

#include <array>
#include <cmath>
#include <span>

namespace vitrine::player {

namespace {

using Vertices = std::vector<CellMesh::Vertex>;

/// A coordinate on the grid on which graphics cards place corners, canvas px. So each part of a canvas is
/// drawn with the same pixels as the whole.
float on_grid(double place) {
    constexpr double fineness = 256;  // places in a px
    return static_cast<float>(std::round(place * fineness) / fineness);
}

void append(Vertices& vertices, Vec2 point, double coverage) {
    vertices.push_back({on_grid(point.x), on_grid(point.y), static_cast<float>(coverage)});
}

template <typename Visit> void for_each_side(std::span<const Polygon> polygons, Visit visit) {
    for (const Polygon& polygon : polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i)
            visit(polygon[i], polygon[(i + 1) % polygon.size()]);
}

/// A strip along the outline. Lines of GL would do, too, but a card may draw them elsewhere in a part of a
/// canvas.
void append_outline(Vertices& vertices, std::span<const Polygon> polygons) {
    constexpr double half_width = 0.5;  // canvas px
    for_each_side(polygons, [&](Vec2 from, Vec2 to) {
        if (to == from) return;
        const Vec2 along = (to - from) * (half_width / length(to - from));
        const Vec2 across{along.y, -along.x};
        for (const Vec2 corner :
             {from + across, to + across, to - across, from + across, to - across, from - across})
            append(vertices, corner, 1);
    });
}

/// True if no pixel lies in a triangle, as its corners share a line of the grid.
bool is_flat(const std::array<Vec2, 3>& triangle) {
    std::array<Vec2, 3> at;
    for (std::size_t i = 0; i < at.size(); ++i)
        at[i] = {on_grid(triangle[i].x), on_grid(triangle[i].y)};
    return cross(at[1] - at[0], at[2] - at[0]) == 0;
}

/// Flat triangles are left out: of three triangles whose last one is flat, Mesa's llvmpipe may draw none.
void append_triangles(Vertices& vertices, std::span<const std::array<Vec2, 3>> triangles) {
    for (const auto& triangle : triangles) {
        if (is_flat(triangle)) continue;
        for (const Vec2 corner : triangle)
            append(vertices, corner, 1);
    }
}

/// @param widths  the fringe's width at each corner, px
void append_fringe(Vertices& vertices, const Polygon& outline, std::span<const double> widths,
                   double coverage) {
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const std::size_t next = (k + 1) % outline.size();
        const Vec2 from = outline[k];
        const Vec2 to = outline[next];
        if (to == from) continue;
        const Vec2 side = to - from;
        const Vec2 outward = Vec2{side.y, -side.x} * (1 / length(side));  // counter-clockwise: inside is left
        append(vertices, from, coverage);
        append(vertices, to, coverage);
        append(vertices, to + outward * widths[next], 0);
        append(vertices, from, coverage);
        append(vertices, to + outward * widths[next], 0);
        append(vertices, from + outward * widths[k], 0);
    }
}

void append_fringe(Vertices& vertices, std::span<const Polygon> polygons, double width, double coverage) {
    for (const Polygon& polygon : polygons)
        append_fringe(vertices, polygon, std::vector<double>(polygon.size(), width), coverage);
}

template <typename Append> CellMesh::Range appended(Vertices& vertices, const Append& append_them) {
    const auto first = static_cast<int>(vertices.size());
    append_them();
    return CellMesh::Range{first, static_cast<int>(vertices.size()) - first};
}

CellMesh::Layer append_layer(Vertices& vertices, std::span<const Polygon> polygons,
                             std::span<const std::array<Vec2, 3>> triangles) {
    CellMesh::Layer layer;
    layer.outline = appended(vertices, [&] { append_outline(vertices, polygons); });
    layer.triangles = appended(vertices, [&] { append_triangles(vertices, triangles); });
    return layer;
}

}  // namespace

CellMesh cell_mesh(const Cell& cell, double fringe) {
    CellMesh mesh;
    Vertices& vertices = mesh.vertices;
    mesh.filler = append_layer(vertices, cell.filler, cell.filler_triangles);
    mesh.filler.fringe = appended(vertices, [&] { append_fringe(vertices, cell.filler, fringe, 0.5); });
    mesh.parts = append_layer(vertices, cell.parts, cell.triangles);
    mesh.parts.fringe = appended(vertices, [&] {
        if (cell.fade_edges.empty()) append_fringe(vertices, cell.parts, fringe, cell.edge_coverage);
        for (const FadeEdge& edge : cell.fade_edges)
            append_fringe(vertices, edge.outline, edge.widths, cell.edge_coverage);
    });
    return mesh;
}

}  // namespace vitrine::player
