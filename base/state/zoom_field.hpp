#pragma once

#include "base/geometry/vec2.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Where the points of a tile lie in the level next to its own: what it shows there is the same, or comes
/// from there. Between both levels each point goes from the one place to the other in a straight line.
/// Points stand in columns `step` px apart, the last at the tile's right edge, and in `rows` rows from its
/// upper edge to its lower one. In each row places go to the right, in each column down.
/// Source: Video Tapestries 4.3; docs/catalogue.md has the format.
struct ZoomField {
    static constexpr int step = 16;  // px
    static constexpr int rows = 11;

    int width = 0;                // px of the tile
    int height = 0;               // px of the strip
    std::vector<Vec2> places;     // row by row, px of the other level's strip, in 1/16
    std::vector<double> growths;  // likewise: px of the other strip a px of this one, across; [0, 8) in 1/32

    int columns() const { return columns_of(width); }

    static int columns_of(int width) { return (width + step - 1) / step + 1; }

    /// px of the tile
    Vec2 point(int column, int row) const {
        return {static_cast<double>(column + 1 == columns() ? width : column * step),
                static_cast<double>(row) * height / (rows - 1)};
    }

    std::size_t number(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
               static_cast<std::size_t>(column);
    }

    const Vec2& place(int column, int row) const { return places[number(column, row)]; }
};

/// A file's bytes.
std::string to_bytes(const ZoomField& field);

/// @throws std::runtime_error where they are no field of this version, or say what cannot be
ZoomField zoom_field_from_bytes(std::string_view bytes);

}  // namespace vitrine
