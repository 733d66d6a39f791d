#include "base/state/zoom_field.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

namespace vitrine {
namespace {

/// A tile of 40 px that becomes twice as wide from 1000.5 on.
ZoomField drawn() {
    ZoomField field{.width = 40, .height = 150, .places = {}, .growths = {}};
    for (int row = 0; row < ZoomField::rows; ++row) {
        for (int column = 0; column < field.columns(); ++column) {
            const Vec2 point = field.point(column, row);
            field.places.push_back({1000.5 + 2 * point.x - row, point.y});
            field.growths.push_back(2 + column / 32.0);
        }
    }
    return field;
}

}  // namespace

TEST_CASE("the points of a tile stand 16 px apart, the last at its edge") {
    const ZoomField field = drawn();
    CHECK(field.columns() == 4);
    CHECK(field.point(2, 0) == Vec2{32, 0});
    CHECK(field.point(3, 10) == Vec2{40, 150});
    CHECK(ZoomField::columns_of(512) == 33);
}

TEST_CASE("a zoom field is read as it was written") {
    const ZoomField field = drawn();
    const ZoomField read = zoom_field_from_bytes(to_bytes(field));
    CHECK(read.width == field.width);
    CHECK(read.height == field.height);
    CHECK(read.places == field.places);
    CHECK(read.growths == field.growths);
}

TEST_CASE("what is no zoom field is refused") {
    const std::string bytes = to_bytes(drawn());
    const auto refused = [](const std::string& some) {
        try {
            (void)zoom_field_from_bytes(some);
        } catch (const std::runtime_error&) {
            return true;
        }
        return false;
    };
    CHECK_FALSE(refused(bytes));
    for (std::size_t length = 0; length < bytes.size(); ++length)
        CHECK(refused(bytes.substr(0, length)));
    CHECK(refused(bytes + "x"));
    std::string other_version = bytes;
    other_version[6] = '2';
    CHECK(refused(other_version));
    std::string too_wide = bytes;
    too_wide[9] = '\x7f';
    CHECK(refused(too_wide));
    std::string behind = bytes;
    behind[15] = '\x7f';  // the origin
    CHECK(refused(behind));
}

TEST_CASE("a zoom field that folds over is refused") {
    ZoomField left = drawn();
    left.places[2].x = left.places[1].x - 1;
    CHECK_THROWS_WITH(zoom_field_from_bytes(to_bytes(left)), doctest::Contains("left"));
    ZoomField up = drawn();
    up.places[static_cast<std::size_t>(up.columns()) * 3].y = 0;
    CHECK_THROWS_WITH(zoom_field_from_bytes(to_bytes(up)), doctest::Contains("up"));
}

}  // namespace vitrine
