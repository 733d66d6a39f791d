#pragma once

#include "analyzer/tapestry/synthesis/brickwork.hpp"
#include "analyzer/tapestry/synthesis/run_tasks.hpp"

#include <algorithm>
#include <vector>

namespace vitrine::analyzer {

enum class TileQuality {
    high,       // up to a second a tile
    on_demand,  // up to a tenth of a second a tile
};

constexpr double kept_height = 0.75;  // share of the brickwork's height; source: Video Tapestries 4.2

/// The px by which a tile reaches into the one before: 64, and more where bricks are taller than 200 px.
int tile_overlap(int brick_height);

/// The neighbour's share in a column of an overlap; column 0 is the outermost. It is 1 in the outer half,
/// then falls to 0.
inline float neighbour_share(int column, int columns) {
    const float place = (static_cast<float>(column) + 0.5F) / static_cast<float>(columns);
    return std::clamp(2 - 2 * place, 0.F, 1.F);
}

/// The tiles of a strip, left to right. Each is about 500 px wide, or 2.5 times as wide as a brick is tall,
/// and begins tile_overlap() px before the end of the one before. A strip of up to 1.5 tiles is one tile.
/// Narrower tiles cut pictures at their borders.
std::vector<TileSpan> tile_spans(int strip_width, int brick_height);

/// The finished neighbours of a tile: pictures as tall as the tapestry, or empty.
struct TileNeighbours {
    cv::Mat left;   // CV_8UC3, the tile's first columns as the neighbour has them
    cv::Mat right;  // CV_8UC3, the tile's last columns as the neighbour has them
};

struct RetargetSettings {
    TileQuality quality = TileQuality::high;
    WindowSettings window;
};

/// Makes one tile of a discrete tapestry: the brickwork 75 % as tall, by bidirectional similarity. Colours of
/// known neighbours are kept: wholly at the border, then less and less into the tile.
///
/// @param section  all bricks in window_of() the tile
/// @return         CV_8UC3, as wide as `span`
/// Source: Video Tapestries 4.2. The result does not depend on the number of threads of `run`.
cv::Mat retarget_tile(const BrickSection& section, const TileSpan& span, const TileNeighbours& neighbours,
                      const RetargetSettings& settings = {}, const RunTasks& run = run_in_order);

int tapestry_height(const Brickwork& brickwork);

}  // namespace vitrine::analyzer
