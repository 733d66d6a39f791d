#include "player/scene/zoom_mesh.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// A tile of 32 px at the 64th of the coarser strip, which goes to the 200th of the finer one, twice as wide.
ZoomField drawn() {
    ZoomField field{.width = 32, .height = 100, .places = {}, .growths = {}};
    for (int row = 0; row < ZoomField::rows; ++row) {
        for (int column = 0; column < field.columns(); ++column) {
            const Vec2 point = field.point(column, row);
            field.places.push_back({200 + 2 * point.x, point.y});
            field.growths.push_back(2);
        }
    }
    return field;
}

}  // namespace

TEST_CASE("a tile's points have their places on both levels, and its picture's") {
    const ZoomMesh mesh = zoom_mesh(drawn(), 64, true);
    REQUIRE(mesh.vertices.size() == 3 * ZoomField::rows);
    CHECK(mesh.coarse_origin == 64);
    CHECK(mesh.fine_origin == 200);
    const ZoomMesh::Vertex& last = mesh.vertices.back();
    CHECK(last.coarse_x == 32);
    CHECK(last.coarse_y == 100);
    CHECK(last.fine_x == 64);
    CHECK(last.u == 1);
    CHECK(last.v == 1);
    CHECK(last.growth < 0);
    CHECK(mesh.coarse_right == 96);
    CHECK(mesh.fine_left == 200);
    CHECK(mesh.fine_right == 264);

    const ZoomMesh back = zoom_mesh(drawn(), 64, false);
    CHECK(back.fine_origin == 64);
    CHECK(back.coarse_origin == 200);
    CHECK(back.vertices.back().fine_x == 32);
    CHECK(back.vertices.back().growth == 2);
}

TEST_CASE("a tile's triangles cover it once") {
    const ZoomMesh mesh = zoom_mesh(drawn(), 0, true);
    double area = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const auto& a = mesh.vertices[mesh.triangles[i]];
        const auto& b = mesh.vertices[mesh.triangles[i + 1]];
        const auto& c = mesh.vertices[mesh.triangles[i + 2]];
        const double twice = (b.coarse_x - a.coarse_x) * (c.coarse_y - a.coarse_y) -
                             (c.coarse_x - a.coarse_x) * (b.coarse_y - a.coarse_y);
        CHECK(twice > 0);
        area += twice / 2;
    }
    CHECK(area == doctest::Approx(32 * 100));
}
