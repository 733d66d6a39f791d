#include "player/scene/tapestry/unwoven_tapestry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int unwoven_height = 150;     // px, as usual
constexpr int unwoven_tile = 512;       // px
constexpr int unwoven_keyframes = 24;   // as many as a coarsest level has
constexpr double rows_of_bricks = 1.5;  // bricks in a tapestry's height

}  // namespace

Tapestry unwoven_tapestry(std::chrono::nanoseconds duration, Vec2 shape) {
    const double width = unwoven_height / rows_of_bricks * shape.x / shape.y;
    Tapestry tapestry{.path = {},
                      .duration = duration,
                      .folder = {},
                      .height = unwoven_height,
                      .tile_width = unwoven_tile,
                      .brick_width = std::max(2, static_cast<int>(std::lround(width))),
                      .levels = {}};
    TapestryLevel level{.width = (unwoven_keyframes + 1) * tapestry.brick_width / 2, .keyframes = {}};
    for (int k = 0; k < unwoven_keyframes; ++k)
        level.keyframes.push_back(duration * (2 * k + 1) / (2 * unwoven_keyframes));
    tapestry.levels.push_back(std::move(level));
    return tapestry;
}

bool is_unwoven(const Tapestry& tapestry) {
    return tapestry.folder.empty();
}

}  // namespace vitrine::player
