#pragma once

#include "base/state/tapestry.hpp"
#include "player/scene/tapestry/film_spans.hpp"

#include <utility>
#include <vector>

namespace vitrine::player {

/// A tapestry as the analyzer would write it, of a film that is a minute long: levels of 4, 8, 16 and 32
/// keyframes, not evenly spaced in time.
inline Tapestry drawn_tapestry(int levels = 4) {
    Tapestry tapestry{.path = "film.mp4",
                      .duration = std::chrono::seconds(60),
                      .is_complete = true,
                      .folder = "tiles",
                      .height = 90,
                      .tile_width = 200,
                      .brick_width = 100,
                      .levels = {}};
    for (int level = 0; level < levels; ++level) {
        const int count = 4 << level;
        TapestryLevel one{.width = (count + 1) * tapestry.brick_width / 2, .keyframes = {}};
        const int finest = 4 << (levels - 1);
        const int step = finest / count;
        for (int k = 0; k < count; ++k) {
            const double at = (k * step + 0.5) / finest;
            one.keyframes.emplace_back(static_cast<std::int64_t>(at * at * 60e9));
        }
        tapestry.levels.push_back(std::move(one));
    }
    return tapestry;
}

/// The film of that tapestry.
inline PreviewedFilm drawn_film(std::vector<Shot> shots = {}) {
    return {.path = "film.mp4",
            .duration = std::chrono::seconds(60),
            .picture = {160, 90},
            .shots = std::move(shots)};
}

}  // namespace vitrine::player
