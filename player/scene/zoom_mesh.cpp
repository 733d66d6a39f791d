#include "player/scene/zoom_mesh.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

constexpr double min_growth = 0.02;  // smaller values are rounding errors of the file's numbers

void widen(double& left, double& right, double x) {
    left = std::min(left, x);
    right = std::max(right, x);
}

std::vector<std::uint16_t> triangles_of(const ZoomField& field) {
    std::vector<std::uint16_t> triangles;
    for (int row = 0; row + 1 < ZoomField::rows; ++row) {
        for (int column = 0; column + 1 < field.columns(); ++column) {
            const auto corner = [&](int x, int y) {
                return static_cast<std::uint16_t>(field.number(column + x, row + y));
            };
            for (const std::uint16_t one :
                 {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 0), corner(1, 1), corner(0, 1)})
                triangles.push_back(one);
        }
    }
    return triangles;
}

}  // namespace

ZoomMesh zoom_mesh(const ZoomField& field, double left, bool is_to_finer) {
    const double other = field.places.front().x;
    ZoomMesh mesh{.vertices = {},
                  .triangles = triangles_of(field),
                  .is_whole = is_to_finer,
                  .coarse_origin = is_to_finer ? left : other,
                  .fine_origin = is_to_finer ? other : left,
                  .coarse_left = is_to_finer ? left : other,
                  .coarse_right = is_to_finer ? left : other,
                  .fine_left = is_to_finer ? other : left,
                  .fine_right = is_to_finer ? other : left};
    for (int row = 0; row < ZoomField::rows; ++row) {
        for (int column = 0; column < field.columns(); ++column) {
            const Vec2 point = field.point(column, row);
            const Vec2 place = field.place(column, row);
            const Vec2 own{left + point.x, point.y};
            const Vec2 coarse = is_to_finer ? own : place;
            const Vec2 fine = is_to_finer ? place : own;
            mesh.vertices.push_back(
                {.coarse_x = static_cast<float>(coarse.x - mesh.coarse_origin),
                 .coarse_y = static_cast<float>(coarse.y),
                 .fine_x = static_cast<float>(fine.x - mesh.fine_origin),
                 .fine_y = static_cast<float>(fine.y),
                 .u = static_cast<float>(point.x / field.width),
                 .v = static_cast<float>(point.y / field.height),
                 .growth = static_cast<float>(
                     is_to_finer ? -1 : std::max(min_growth, field.growths[field.number(column, row)]))});
            widen(mesh.coarse_left, mesh.coarse_right, coarse.x);
            widen(mesh.fine_left, mesh.fine_right, fine.x);
        }
    }
    return mesh;
}

}  // namespace vitrine::player
