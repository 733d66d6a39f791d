#include "player/scene/tapestry/tile_cache.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace vitrine::player {

namespace {

/// A list of tiles without repeats, of limited length.
class TileList {
  public:
    explicit TileList(std::size_t max_tiles) : max_tiles_(max_tiles) {}

    /// Appends the tiles that are not listed yet, the nearest to `from` first. Tiles behind it, seen in the
    /// direction of motion, count with twice their distance.
    /// @param tiles  tiles with their middles, canvas px
    void add(std::vector<std::pair<TileId, double>> tiles, double from, double direction) {
        const auto distance = [&](double x) {
            const bool is_ahead = (x - from) * direction >= 0;
            return std::abs(x - from) * (is_ahead ? 1 : 2);
        };
        std::ranges::stable_sort(tiles, {}, [&](const auto& tile) { return distance(tile.second); });
        for (const auto& [tile, x] : tiles)
            if (list_.size() < max_tiles_ && known_.insert(tile).second) list_.push_back(tile);
    }

    std::vector<TileId> take_list() { return std::move(list_); }

  private:
    std::size_t max_tiles_;
    std::set<TileId> known_;
    std::vector<TileId> list_;
};

}  // namespace

std::vector<TileId> wanted_tiles(const TapestryPlace& place, const TapestryView& view, double direction,
                                 std::size_t max_tiles) {
    const Box& box = place.box();
    const double middle = (box.min.x + box.max.x) / 2;
    const auto coarse = static_cast<std::size_t>(view.level);
    const auto last = static_cast<std::size_t>(place.max_level());
    const std::size_t fine = std::min(last, view.level > static_cast<double>(coarse) ? coarse + 1 : coarse);
    TileList list(max_tiles);
    const double reach = place.brick_width();  // strip px that a zoom needs beyond the view
    for (const std::size_t level : {coarse, fine})
        list.add(place.tiles(view, level, box.min.x, box.max.x), middle, 0);
    list.add(place.tiles({.centre = view.centre, .level = 0}, 0, box.min.x, box.max.x), middle, 0);
    for (const std::size_t level : {coarse, fine})
        list.add(place.tiles(view, level, box.min.x - box.width(), box.max.x + box.width()), middle,
                 direction);
    for (const std::size_t level : {std::min(fine + 1, last), coarse > 0 ? coarse - 1 : 0}) {
        const TapestryView there =
            place.bounded({.centre = view.centre, .level = static_cast<double>(level)});
        list.add(place.tiles(there, level, box.min.x - reach, box.max.x + reach), middle, direction);
    }
    const TapestryView here{.centre = view.centre, .level = std::round(view.level)};
    list.add(place.tiles(here, std::min(fine + 1, last), box.min.x - reach, box.max.x + reach), middle, 0);
    return list.take_list();
}

void TileCache::set_wanted(std::span<const TileId> wanted) {
    ++turn_;
    wanted_.assign(wanted.begin(),
                   wanted.begin() + static_cast<std::ptrdiff_t>(std::min(max_tiles_, wanted.size())));
    for (const TileId& tile : wanted_)
        if (const auto found = tiles_.find(tile); found != tiles_.end()) found->second.turn = turn_;
}

std::vector<TileId> TileCache::missing() const {
    std::vector<TileId> missing;
    std::ranges::copy_if(wanted_, std::back_inserter(missing),
                         [&](const TileId& tile) { return !tiles_.contains(tile); });
    return missing;
}

std::vector<TileId> TileCache::add(const TileId& tile, TileZooms zooms) {
    const bool is_wanted = std::ranges::find(wanted_, tile) != wanted_.end();
    if (!is_wanted) {
        tiles_.erase(tile);
        return {tile};
    }
    tiles_[tile] = {.turn = turn_, .zooms = std::move(zooms)};
    std::vector<TileId> gone;
    while (tiles_.size() > max_tiles_) {
        const auto oldest =
            std::ranges::min_element(tiles_, {}, [](const auto& entry) { return entry.second.turn; });
        gone.push_back(oldest->first);
        tiles_.erase(oldest);
    }
    return gone;
}

std::shared_ptr<const ZoomMesh> TileCache::zoom(const TileId& tile, bool is_to_finer) const {
    const auto found = tiles_.find(tile);
    if (found == tiles_.end()) return nullptr;
    return is_to_finer ? found->second.zooms.to_finer : found->second.zooms.to_coarser;
}

std::vector<TileId> TileCache::clear() {
    std::vector<TileId> all;
    all.reserve(tiles_.size());
    for (const auto& [tile, entry] : tiles_)
        all.push_back(tile);
    tiles_.clear();
    return all;
}

}  // namespace vitrine::player
