#include "player/scene/tapestry/tapestry_strip.hpp"

#include "player/scene/tapestry/kept_frames.hpp"
#include "player/scene/tapestry/unwoven_tapestry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr std::int64_t min_tiles = 16;

std::size_t max_tiles_of(const Tapestry& tapestry, std::int64_t bytes) {
    const std::int64_t tile = std::int64_t{4} * tapestry.tile_width * tapestry.height;
    return static_cast<std::size_t>(std::max(min_tiles, bytes / tile));
}

}  // namespace

TapestryStrip::TapestryStrip(Tapestry tapestry, TapestrySources sources, std::int64_t max_bytes)
    : tapestry_(std::move(tapestry)),
      sources_(sources),
      tiles_(max_tiles_of(tapestry_, max_bytes)),
      kept_(max_kept_pictures) {}

void TapestryStrip::want_all(const TapestryPlace& place, const TapestryView& view, double direction,
                             std::optional<nanoseconds> moment) {
    if (is_unwoven(tapestry_)) return;
    tiles_.set_wanted(wanted_tiles(place, view, direction, tiles_.max_tiles()));
    kept_.set_wanted(wanted_pictures(place, view, tapestry_, moment));
}

void TapestryStrip::want_seen(const TapestryPlace& place, const TapestryView& view) {
    std::vector<TileId> seen;
    const Box& box = place.box();
    const auto fine = static_cast<std::size_t>(std::ceil(view.level));
    for (auto level = static_cast<std::size_t>(view.level); level <= fine; ++level)
        for (const auto& [tile, middle] : place.tiles(view, level, box.min.x, box.max.x))
            seen.push_back(tile);
    tiles_.set_wanted(seen);
    if (tapestry_.digits.width > 0) kept_.set_wanted(std::vector{digits_picture(tapestry_)});
}

std::vector<TileId> TapestryStrip::missing(bool is_looking) const {
    std::vector<TileId> first = is_looking ? kept_.missing() : tiles_.missing();
    const std::vector<TileId> second = is_looking ? tiles_.missing() : kept_.missing();
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

std::vector<SourceId> TapestryStrip::add(const TileId& tile, TileZooms zooms) {
    TileCache& cache = is_of_level(tapestry_, tile) ? tiles_ : kept_;
    std::vector<SourceId> gone;
    for (const TileId& dropped : cache.add(tile, std::move(zooms)))
        gone.push_back(sources_.tile(dropped));
    return gone;
}

std::vector<SourceId> TapestryStrip::clear() {
    std::vector<SourceId> all;
    for (TileCache* cache : {&tiles_, &kept_})
        for (const TileId& tile : cache->clear())
            all.push_back(sources_.tile(tile));
    return all;
}

}  // namespace vitrine::player
