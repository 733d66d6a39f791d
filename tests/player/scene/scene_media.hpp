#pragma once

#include "base/state/record.hpp"

#include <chrono>
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

}  // namespace vitrine::player
