#include "player/render/cell_mesh.hpp"

#include <array>
#include <span>

namespace vitrine {

namespace {

constexpr double seam_coverage = 0.5;  // on the seam itself each of the two cells has half

using Vertices = std::vector<CellMesh::Vertex>;

void append(Vertices& vertices, Vec2 point, double coverage) {
    vertices.push_back(
        {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(coverage)});
}

template <typename Visit> void for_each_side(std::span<const Polygon> polygons, Visit visit) {
    for (const Polygon& polygon : polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i)
            visit(polygon[i], polygon[(i + 1) % polygon.size()]);
}

void append_outline(Vertices& vertices, std::span<const Polygon> polygons) {
    for_each_side(polygons, [&](Vec2 from, Vec2 to) {
        append(vertices, from, 1);
        append(vertices, to, 1);
    });
}

void append_triangles(Vertices& vertices, std::span<const std::array<Vec2, 3>> triangles) {
    for (const auto& triangle : triangles)
        for (const Vec2 corner : triangle)
            append(vertices, corner, 1);
}

void append_fringe(Vertices& vertices, std::span<const Polygon> polygons, double width) {
    for_each_side(polygons, [&](Vec2 from, Vec2 to) {
        const Vec2 side = to - from;
        if (length(side) == 0) return;
        const Vec2 outward =
            Vec2{side.y, -side.x} * (width / length(side));  // counter-clockwise: inside is left
        append(vertices, from, seam_coverage);
        append(vertices, to, seam_coverage);
        append(vertices, to + outward, 0);
        append(vertices, from, seam_coverage);
        append(vertices, to + outward, 0);
        append(vertices, from + outward, 0);
    });
}

CellMesh::Layer append_layer(Vertices& vertices, std::span<const Polygon> polygons,
                             std::span<const std::array<Vec2, 3>> triangles, double fringe) {
    const auto appended = [&](auto append_them) {
        const auto first = static_cast<int>(vertices.size());
        append_them();
        return CellMesh::Range{first, static_cast<int>(vertices.size()) - first};
    };
    CellMesh::Layer layer;
    layer.outline = appended([&] { append_outline(vertices, polygons); });
    layer.triangles = appended([&] { append_triangles(vertices, triangles); });
    layer.fringe = appended([&] { append_fringe(vertices, polygons, fringe); });
    return layer;
}

}  // namespace

CellMesh cell_mesh(const Cell& cell, double fringe) {
    CellMesh mesh;
    mesh.filler = append_layer(mesh.vertices, cell.filler, cell.filler_triangles, fringe);
    mesh.parts = append_layer(mesh.vertices, cell.parts, cell.triangles, fringe);
    return mesh;
}

}  // namespace vitrine
