#include "player/scene/tapestry/tile_cache.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace vitrine::player {

namespace {

/// Takes each tile once, in order, until there are enough.
class Order {
  public:
    explicit Order(std::size_t most) : most_(most) {}

    void add(std::vector<std::pair<TileId, double>> tiles, double from, double direction) {
        const auto way = [&](double x) {
            const bool is_ahead = (x - from) * direction >= 0;
            return std::abs(x - from) * (is_ahead ? 1 : 2);
        };
        std::ranges::stable_sort(tiles, {}, [&](const auto& tile) { return way(tile.second); });
        for (const auto& [tile, x] : tiles)
            if (order_.size() < most_ && known_.insert(tile).second) order_.push_back(tile);
    }

    std::vector<TileId> take() { return std::move(order_); }

  private:
    std::size_t most_;
    std::set<TileId> known_;
    std::vector<TileId> order_;
};

}  // namespace

std::vector<TileId> wanted_tiles(const TapestryPlace& place, const TapestryView& view, double direction,
                                 std::size_t most) {
    const Box& box = place.box();
    const double middle = (box.min.x + box.max.x) / 2;
    const auto coarse = static_cast<std::size_t>(view.level);
    const auto last = static_cast<std::size_t>(place.most_level());
    const std::size_t fine = std::min(last, view.level > static_cast<double>(coarse) ? coarse + 1 : coarse);
    Order order(most);
    const double reach = place.brick_width();  // a zoom needs so much more
    for (const std::size_t level : {coarse, fine})
        order.add(place.tiles(view, level, box.min.x, box.max.x), middle, 0);
    order.add(place.tiles({.centre = view.centre, .level = 0}, 0, box.min.x, box.max.x), middle, 0);
    for (const std::size_t level : {coarse, fine})
        order.add(place.tiles(view, level, box.min.x - box.width(), box.max.x + box.width()), middle,
                  direction);
    for (const std::size_t level : {std::min(fine + 1, last), coarse > 0 ? coarse - 1 : 0}) {
        const TapestryView there =
            place.bounded({.centre = view.centre, .level = static_cast<double>(level)});
        order.add(place.tiles(there, level, box.min.x - reach, box.max.x + reach), middle, direction);
    }
    const TapestryView here{.centre = view.centre, .level = std::round(view.level)};
    order.add(place.tiles(here, std::min(fine + 1, last), box.min.x - reach, box.max.x + reach), middle, 0);
    return order.take();
}

void TileCache::wish(std::span<const TileId> wanted) {
    ++turn_;
    wanted_.assign(wanted.begin(),
                   wanted.begin() + static_cast<std::ptrdiff_t>(std::min(most_, wanted.size())));
    for (const TileId& tile : wanted_)
        if (const auto found = tiles_.find(tile); found != tiles_.end()) found->second = turn_;
}

std::vector<TileId> TileCache::missing() const {
    std::vector<TileId> missing;
    std::ranges::copy_if(wanted_, std::back_inserter(missing),
                         [&](const TileId& tile) { return !tiles_.contains(tile); });
    return missing;
}

std::vector<TileId> TileCache::add(const TileId& tile) {
    const bool is_wanted = std::ranges::find(wanted_, tile) != wanted_.end();
    if (!is_wanted) return {tile};
    tiles_[tile] = turn_;
    std::vector<TileId> gone;
    while (tiles_.size() > most_) {
        const auto oldest =
            std::ranges::min_element(tiles_, {}, [](const auto& entry) { return entry.second; });
        gone.push_back(oldest->first);
        tiles_.erase(oldest);
    }
    return gone;
}

std::vector<TileId> TileCache::clear() {
    std::vector<TileId> all;
    all.reserve(tiles_.size());
    for (const auto& [tile, turn] : tiles_)
        all.push_back(tile);
    tiles_.clear();
    return all;
}

}  // namespace vitrine::player
