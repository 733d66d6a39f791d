#include "player/layout/edit/wall_way.hpp"

#include "base/geometry/convex_hull.hpp"
#include "player/layout/cells/cells.hpp"
#include "player/layout/plan/motion.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace vitrine::player {

namespace {

/// A wall in which each group of another wall's items is one item.
struct Bodies {
    WallState wall;
    std::vector<std::vector<std::size_t>> members;  // of each body; several: a group, placed from its home
};

/// The hull of a group at home.
LayoutItem hull_of(const std::vector<std::size_t>& members, const WallState& wall) {
    LayoutItem body;
    Polygon points;
    for (const std::size_t i : members) {
        const Placement& home = wall.homes[i];
        const Polygon region = placed_region(wall.items[i], home);
        points.insert(points.end(), region.begin(), region.end());
        const Box core = placed_core(wall.items[i], home);
        body.core = body.core.is_empty() ? core : united(body.core, core);
    }
    body.region = convex_hull(points);
    return body;
}

std::vector<std::vector<std::size_t>> members_of(const WayRequest& request) {
    std::vector<std::vector<std::size_t>> members;
    std::vector<bool> is_grouped(request.wall.items.size(), false);
    for (const LayoutGroup& group : request.groups) {
        if (group.items.size() < 2) continue;
        members.push_back(group.items);
        for (const std::size_t item : group.items)
            is_grouped[item] = true;
    }
    for (std::size_t i = 0; i < is_grouped.size(); ++i)
        if (!is_grouped[i]) members.push_back({i});
    return members;
}

Bodies bodies_of(const WayRequest& request) {
    Bodies bodies{.wall = {.canvas = request.wall.canvas}, .members = members_of(request)};
    for (const std::vector<std::size_t>& members : bodies.members) {
        const std::size_t first = members.front();
        const bool is_group = members.size() > 1;
        const Placement& home = request.wall.homes[first];
        const Placement& now = request.wall.placements[first];
        bodies.wall.items.push_back(is_group ? hull_of(members, request.wall) : request.wall.items[first]);
        bodies.wall.placements.push_back(is_group ? change_between(home, now) : now);
        bodies.wall.homes.push_back(is_group ? Placement{} : home);
        if (!is_group && std::ranges::find(request.wall.pinned, first) != request.wall.pinned.end())
            bodies.wall.pinned.push_back(bodies.wall.items.size() - 1);
    }
    return bodies;
}

/// The wishes for the bodies: a group goes where its first wished member shall be.
std::vector<Wish> wishes_of(const Bodies& bodies, const WayRequest& request) {
    std::vector<Wish> wishes;
    for (const Wish& wish : request.wishes)
        for (std::size_t k = 0; k < bodies.members.size(); ++k) {
            const auto& members = bodies.members[k];
            if (std::ranges::find(members, wish.item) == members.end()) continue;
            if (std::ranges::find(wishes, k, &Wish::item) != wishes.end()) continue;
            const Placement at =
                members.size() > 1 ? change_between(request.wall.homes[wish.item], wish.at) : wish.at;
            wishes.push_back({.item = k, .at = at, .is_let_go = wish.is_let_go});
        }
    return wishes;
}

/// The placements of all items, where the bodies are at these.
std::vector<Placement> unfolded(const Bodies& bodies, const WayRequest& request,
                                std::span<const Placement> placements) {
    std::vector<Placement> all(request.wall.items.size());
    for (std::size_t k = 0; k < bodies.members.size(); ++k)
        for (const std::size_t i : bodies.members[k])
            all[i] =
                bodies.members[k].size() > 1 ? composed(request.wall.homes[i], placements[k]) : placements[k];
    return all;
}

/// A body that fades from place to place, as it has no free way, or into its place from above the wall.
struct Fader {
    std::size_t body = 0;
    std::size_t leaves =
        0;  // the number of the key at which it is gone from its old place; 0: it was above the wall
    std::size_t comes = 0;  // the last key at which it is not yet at its new place

    /// Its opacity at a key. @param last  the number of the last key, whose wall is complete
    double alpha(std::size_t key, std::size_t last) const {
        if (key < leaves) return 1 - static_cast<double>(key) / static_cast<double>(leaves);
        if (key <= comes) return 0;
        return static_cast<double>(key - comes) / static_cast<double>(last - comes);
    }
};

/// The bodies of some places of a list.
template <typename Value>
std::vector<Value> chosen(const std::vector<Value>& all, std::span<const std::size_t> places) {
    std::vector<Value> some;
    some.reserve(places.size());
    for (const std::size_t k : places)
        some.push_back(all[k]);
    return some;
}

/// The way of a body: with the others, into its place from above the wall, from its place on the wall to
/// another one meanwhile, or none, as a hand has it.
enum class Lifting { none, returns, is_put, in_hand };

/// Finds out which bodies move, and how, and which ones fade. One in a hand does neither.
class WayMotion {
  public:
    /// @param lifting  one for each body
    WayMotion(const WallState& wall, const WallState& next, const std::vector<Lifting>& lifting,
              std::size_t keys)
        : wall_(wall), next_(next), last_(keys) {
        for (std::size_t k = 0; k < wall.items.size(); ++k)
            if (lifting[k] == Lifting::none) moving_.push_back(k);
        find_motion();
        wayless_ = faders_.size();
        for (std::size_t k = 0; k < wall.items.size(); ++k) {
            if (lifting[k] == Lifting::returns) faders_.push_back(fader_of(k, 0));
            if (lifting[k] == Lifting::is_put) faders_.push_back(fader_of(k, half()));
        }
    }

    /// The placements of all bodies at a key; lifted ones are where they will be.
    std::vector<Placement> placements_at_key(std::size_t key) const {
        std::vector<Placement> all = next_.placements;
        const std::vector<Placement> moved =
            placements_at(motion_, static_cast<double>(key) / static_cast<double>(last_));
        for (std::size_t k = 0; k < moving_.size(); ++k)
            all[moving_[k]] = moved[k];
        for (const Fader& fader : faders_)
            if (key < fader.leaves) all[fader.body] = wall_.placements[fader.body];
        return all;
    }

    const std::vector<Fader>& faders() const { return faders_; }

    /// The number of bodies without a free way.
    std::size_t wayless() const { return wayless_; }

  private:
    std::size_t half() const { return std::max<std::size_t>(1, last_ / 2); }

    /// Lets one body after the other fade until the rest has a free way.
    void find_motion() {
        std::vector<std::size_t> fading;
        for (;;) {
            const std::vector<LayoutItem> items = chosen(wall_.items, moving_);
            const std::vector<Placement> from = chosen(wall_.placements, moving_);
            const std::vector<Placement> to = chosen(next_.placements, moving_);
            if (auto found = motion_between(items, from, to, wall_.canvas)) {
                motion_ = std::move(*found);
                break;
            }
            const std::vector<int> counts = meetings(items, from, to);
            const auto most = std::ranges::max_element(counts) - counts.begin();
            fading.push_back(moving_[static_cast<std::size_t>(most)]);
            moving_.erase(moving_.begin() + most);
        }
        for (const std::size_t body : fading)
            faders_.push_back(fader_of(body, half()));
    }

    /// True if a body at a place shares inner points with one that moves, at a key.
    bool is_blocked(std::size_t body, const Placement& at, std::size_t key) const {
        const std::vector<Placement> now =
            placements_at(motion_, static_cast<double>(key) / static_cast<double>(last_));
        for (std::size_t k = 0; k < moving_.size(); ++k)
            if (!overlap_interval({wall_.items[body], at, at}, {wall_.items[moving_[k]], now[k], now[k]}, 0)
                     .is_empty())
                return true;
        return false;
    }

    /// @param leaves  the key at which it is gone at the latest
    Fader fader_of(std::size_t body, std::size_t leaves) const {
        Fader fader{.body = body, .leaves = leaves, .comes = last_ / 2};
        for (std::size_t key = leaves; key > 0; --key)
            if (is_blocked(body, wall_.placements[body], key)) fader.leaves = key;
        for (std::size_t key = last_ / 2; key < last_; ++key)
            if (is_blocked(body, next_.placements[body], key)) fader.comes = key;
        return fader;
    }

    const WallState& wall_;  // outlives this
    const WallState& next_;  // outlives this
    std::size_t last_;       // the number of the last key
    std::vector<std::size_t> moving_;
    Motion motion_;
    std::vector<Fader> faders_;
    std::size_t wayless_ = 0;
};

/// Makes the keys of a way.
class WayKeys {
  public:
    using Cells = std::vector<std::shared_ptr<const Cell>>;

    WayKeys(const WayRequest& request, const Bodies& bodies, const WallState& next)
        : request_(request),
          bodies_(bodies),
          is_in_hand_(request.wall.items.size(), false),
          is_shot_(request.wall.items.size(), true),
          motion_(bodies.wall, next, lifting(), request.keys),
          end_(unfolded(bodies, request, next.placements)) {
        for (const std::size_t pinned : request.wall.pinned)
            is_shot_[pinned] = false;
    }

    std::vector<WallKey> made() {
        std::vector<WallKey> keys;
        const WallKey last = last_key();
        for (std::size_t k = 1; k < request_.keys; ++k)
            keys.push_back(key_at(k, last));
        keys.push_back(last);
        return keys;
    }

    std::size_t wayless() const { return motion_.wayless(); }

  private:
    /// Notes which items are in hands. @return one for each body; one of several items is never lifted
    std::vector<Lifting> lifting() {
        std::vector<Lifting> found;
        for (const std::vector<std::size_t>& members : bodies_.members) {
            const std::size_t item = members.front();
            found.push_back(Lifting::none);
            const auto lifted = std::ranges::find(request_.lifted, item, &LiftedItem::item);
            if (members.size() > 1 || lifted == request_.lifted.end()) continue;
            is_in_hand_[item] = std::ranges::any_of(
                request_.wishes, [&](const Wish& wish) { return wish.item == item && !wish.is_let_go; });
            found.back() = is_in_hand_[item] ? Lifting::in_hand
                           : lifted->is_seen ? Lifting::is_put
                                             : Lifting::returns;
        }
        return found;
    }

    /// The cells of some items, in a layout of only these. nullptr: of the others.
    Cells cells_of(const std::vector<Placement>& placements, const std::vector<bool>& is_in) const {
        std::vector<LayoutItem> items;
        Layout layout{.canvas = request_.wall.canvas};
        std::vector<std::size_t> places(placements.size(), 0);
        for (std::size_t i = 0; i < placements.size(); ++i) {
            if (!is_in[i]) continue;
            places[i] = items.size();
            items.push_back(
                without_bleeding_edge(request_.wall.items[i], request_.pictures[i], placements[i]));
            layout.placements.push_back(placements[i]);
        }
        for (const LayoutGroup& group : request_.groups)
            if (group.items.size() > 1 && is_in[group.items.front()])
                layout.groups.push_back({.items = chosen(places, group.items)});
        std::vector<Cell> made = cells(items, layout, request_.cells);
        Cells all(placements.size());
        for (std::size_t i = 0; i < placements.size(); ++i)
            if (is_in[i]) all[i] = std::make_shared<const Cell>(std::move(made[places[i]]));
        return all;
    }

    /// The wall at the end. Items in hands have their cells above those of the others.
    WallKey last_key() const {
        std::vector<bool> is_in = is_shot_;
        WallKey key{.placements = end_,
                    .cells = cells_of(end_, is_in),
                    .alphas = std::vector<double>(end_.size(), 1)};
        for (std::size_t i = 0; i < end_.size(); ++i)
            is_in[i] = is_shot_[i] && !is_in_hand_[i];
        if (is_in == is_shot_) return key;
        const Cells below = cells_of(end_, is_in);
        for (std::size_t i = 0; i < end_.size(); ++i) {
            if (is_in[i]) key.cells[i] = below[i];
            key.alphas[i] = is_in_hand_[i] ? 0 : 1;
        }
        return key;
    }

    WallKey key_at(std::size_t number, const WallKey& last) const {
        WallKey key{.placements = unfolded(bodies_, request_, motion_.placements_at_key(number)),
                    .cells = {},
                    .alphas = std::vector<double>(end_.size(), 1)};
        std::vector<bool> is_below = is_in_hand_;
        std::vector<bool> is_seen = is_in_hand_;
        for (std::size_t i = 0; i < end_.size(); ++i)
            if (is_in_hand_[i]) key.alphas[i] = 0;
        for (const Fader& fader : motion_.faders())
            for (const std::size_t i : bodies_.members[fader.body]) {
                key.alphas[i] = fader.alpha(number, request_.keys);
                is_below[i] = true;
                is_seen[i] = key.alphas[i] <= 0;
            }
        is_below.flip();
        is_seen.flip();
        for (std::size_t i = 0; i < end_.size(); ++i)
            if (!is_shot_[i]) is_below[i] = is_seen[i] = false;
        key.cells = cells_of(key.placements, is_below);
        const Cells above = is_seen == is_below ? Cells(end_.size()) : cells_of(key.placements, is_seen);
        for (std::size_t i = 0; i < end_.size(); ++i)
            if (!is_below[i]) key.cells[i] = above[i] ? above[i] : last.cells[i];
        return key;
    }

    const WayRequest& request_;  // outlives this
    const Bodies& bodies_;       // outlives this
    std::vector<bool> is_in_hand_;
    std::vector<bool> is_shot_;  // false: pinned, only its place is kept free
    WayMotion motion_;
    std::vector<Placement> end_;
};

}  // namespace

WallWay way_to(const WayRequest& request) {
    const Bodies bodies = bodies_of(request);
    const WallState next = made_way(bodies.wall, wishes_of(bodies, request), request.rules);
    WayKeys keys(request, bodies, next);
    return {.keys = keys.made(), .homes = unfolded(bodies, request, next.homes), .wayless = keys.wayless()};
}

}  // namespace vitrine::player
