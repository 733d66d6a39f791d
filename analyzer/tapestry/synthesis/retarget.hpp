#pragma once

#include "analyzer/tapestry/synthesis/brickwork.hpp"
#include "analyzer/tapestry/synthesis/run_tasks.hpp"

#include <algorithm>
#include <vector>

namespace vitrine::analyzer {

enum class TileQuality {
    high,       // up to a second a tile
    on_demand,  // up to a tenth of one
};

constexpr double kept_height = 0.75;  // of the brickwork's; source: Video Tapestries 4.2
constexpr int tile_overlap = 64;      // px with which a tile begins in the one before

/// The neighbour's share in a column of an overlap, the outermost being 0: all of it in the
/// outer half, then less and less.
inline float neighbour_share(int column, int columns) {
    const float place = (static_cast<float>(column) + 0.5F) / static_cast<float>(columns);
    return std::clamp(2 - 2 * place, 0.F, 1.F);
}

/// The tiles of a strip, left to right, each about 500 px wide and beginning tile_overlap px before the last
/// ends. A strip of up to 1.5 tiles is one.
std::vector<TileSpan> tile_spans(int strip_width);

/// The finished neighbours of a tile: pictures as tall as the tapestry, or empty.
struct TileNeighbours {
    cv::Mat left;   // CV_8UC3, the tile's first columns as the neighbour has them
    cv::Mat right;  // its last ones
};

struct RetargetSettings {
    TileQuality quality = TileQuality::high;
    WindowSettings window;
};

/// One tile of a discrete tapestry: the brickwork 75 % as tall, by bidirectional similarity. Where neighbours
/// are known their colours are kept: whole at the border, then fading into the tile.
///
/// @param section  all bricks in window_of() the tile
/// @return         CV_8UC3, to - from wide
/// Source: Video Tapestries 4.2. The result does not depend on how many threads `run` has.
cv::Mat retarget_tile(const BrickSection& section, const TileSpan& span, const TileNeighbours& neighbours,
                      const RetargetSettings& settings = {}, const RunTasks& run = run_in_order);

int tapestry_height(const Brickwork& brickwork);

}  // namespace vitrine::analyzer
