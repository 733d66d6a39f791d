#pragma once

#include "base/geometry/vec2.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// The places of a tile's points in the next finer or coarser level, where the same content is, or the
/// content that it comes from. While the view goes from one level to the other, each point moves between its
/// two places in a straight line. The points form columns `step` px apart, the last one at the tile's right
/// edge, and `rows` rows from its upper edge to its lower one. Places go to the right in each row and down in
/// each column. Source: Video Tapestries 4.3; docs/catalogue.md has the format.
struct ZoomField {
    static constexpr int step = 16;  // px
    static constexpr int rows = 11;

    int width = 0;                // px of the tile
    int height = 0;               // px of the level
    std::vector<Vec2> places;     // row by row, px of the other level, in steps of 1/16
    std::vector<double> growths;  // row by row, horizontal px of the other level for one px of this one; [0,
                                  // 8), in steps of 1/32

    int columns() const { return columns_of(width); }

    static int columns_of(int width) { return (width + step - 1) / step + 1; }

    /// The place of a point on its tile, px.
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

/// The content of a file.
std::string to_bytes(const ZoomField& field);

/// @throws std::runtime_error if the bytes are no field of this version or have impossible values
ZoomField zoom_field_from_bytes(std::string_view bytes);

}  // namespace vitrine
