#pragma once

#include "base/state/record.hpp"
#include "player/scene/show.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// Records as the analyzer would write them, with a region in the middle of a 640 x 360 picture.
inline IRegion middle() {
    return {.polygon = {{240, 120}, {400, 120}, {400, 240}, {240, 240}}, .drift = {}};
}

inline MediaRecord photo(std::string path, std::int64_t mtime_ns = 1) {
    return {.path = std::move(path),
            .kind = MediaKind::photo,
            .bytes = 1000,
            .mtime_ns = mtime_ns,
            .state = MediaState::ready,
            .width = 640,
            .height = 360,
            .shots = {{.region = middle()}}};
}

/// p100, p101, ...
inline std::vector<MediaRecord> photos(int count) {
    std::vector<MediaRecord> records;
    for (int i = 0; i < count; ++i)
        records.push_back(photo("p" + std::to_string(100 + i)));
    return records;
}

inline MediaRecord film(std::string path, int shots,
                        std::chrono::nanoseconds length = std::chrono::seconds(4)) {
    MediaRecord record = photo(std::move(path));
    record.kind = MediaKind::film;
    record.duration = shots * length;
    record.shots.clear();
    for (int i = 0; i < shots; ++i) {
        record.shots.push_back({.begin = i * length, .end = (i + 1) * length, .region = middle()});
    }
    return record;
}

/// A layout of such shots in a row, as large as the canvas allows.
inline Layout side_by_side(const WallPlan& plan) {
    Layout layout{.canvas = plan.canvas, .generation = plan.generation, .is_final = true};
    const double step = plan.canvas.x / static_cast<double>(plan.items.size());
    const double scale = std::min(step / 170, plan.canvas.y / 130);
    for (std::size_t i = 0; i < plan.items.size(); ++i) {
        const Vec2 place{(static_cast<double>(i) + 0.5) * step, plan.canvas.y / 2};
        layout.placements.push_back({.scale = scale, .offset = place - Vec2{320, 180} * scale});
    }
    return layout;
}

}  // namespace vitrine::player
