#pragma once

#include "player/layout/edit/make_way.hpp"
#include "player/layout/plan/plan.hpp"
#include "player/scene/wall_cells.hpp"
#include "tests/player/layout/instances.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace vitrine::player {

/// Where the items of a wall come from.
using DrawItems = std::function<LayoutItem(Random&)>;

/// A wall that is planned and changed as the player does, without files, sources and time.
class ChangingWall {
  public:
    using Shots = std::vector<PlacedShot>;

    ChangingWall(Vec2 canvas, std::size_t count, std::uint64_t seed, DrawItems draw = random_item,
                 const CellStyle& style = {})
        : canvas_(canvas), random_(seed), seed_(seed), draw_(std::move(draw)), style_(style) {
        PlanRequest request;
        Shots wall;
        for (std::size_t i = 0; i < count; ++i) {
            wall.push_back(newcomer(static_cast<int>(i)));
            request.items.push_back({.item = wall.back().shot.item});
        }
        shown_ = laid_out(std::move(wall), std::move(request));
    }

    Vec2 canvas() const { return canvas_; }

    const Shots& shown() const { return shown_; }

    /// The wall after a change becomes the shown one.
    void show(Shots wall) { shown_ = std::move(wall); }

    /// One shot gives its seat to another one.
    Shots turned() {
        Shots next = shown_;
        PlanRequest request = request_of_shown();
        const std::size_t item = uniform_index(random_, next.size());
        const Seat seat = seat_of(next[item].shot.item, next[item].placement);
        next[item] = newcomer(next[item].shot.slot);
        request.items[item] = {.item = next[item].shot.item, .seat = seat};
        return laid_out(std::move(next), std::move(request));
    }

    Shots with_one_more() {
        Shots next = shown_;
        PlanRequest request = request_of_shown();
        next.push_back(newcomer(100 + static_cast<int>(last_)));
        request.items.push_back({.item = next.back().shot.item});
        return laid_out(std::move(next), std::move(request));
    }

    Shots with_one_less() {
        Shots next = shown_;
        PlanRequest request = request_of_shown();
        const auto item = static_cast<std::ptrdiff_t>(uniform_index(random_, next.size()));
        next.erase(next.begin() + item);
        request.items.erase(request.items.begin() + item);
        return laid_out(std::move(next), std::move(request));
    }

    /// A finger takes a shot to any place and drops it there. Each step of the wall becomes the shown one.
    /// @param on_step  gets each step before it is shown
    void drag(const std::function<void(const Shots& next)>& on_step) {
        constexpr int steps = 8;
        const std::size_t held = uniform_index(random_, shown_.size());
        const Placement home = shown_[held].placement;
        const Vec2 from = seat_of(shown_[held].shot.item, home).centre;
        const double x = uniform(random_);
        const Vec2 to{canvas_.x * x, canvas_.y * uniform(random_)};
        WallState wall{.canvas = canvas_};
        for (const PlacedShot& placed : shown_) {
            wall.items.push_back(placed.shot.item);
            wall.homes.push_back(placed.placement);
            wall.pinned.push_back(false);
        }
        wall.placements = wall.homes;
        for (int k = 1; k <= steps + 1; ++k) {
            const Vec2 finger = from + (to - from) * (k / double{steps});
            const Placement at{home.scale * 0.75, finger - (from - home.offset) * 0.75};
            const std::vector<Wish> wishes{{.item = held, .at = at, .is_let_go = k > steps}};
            wall = made_way(wall, wishes, {.seed = seed_++, .budget = 20'000});
            Shots next = shown_;
            for (std::size_t i = 0; i < next.size(); ++i)
                next[i].placement = wall.placements[i];
            give_cells(next, canvas_, {});
            on_step(next);
            show(std::move(next));
        }
    }

  private:
    PlacedShot newcomer(int slot) {
        PlacedShot placed{.shot = {.source = ++last_, .slot = slot}};
        placed.shot.item = draw_(random_);
        placed.shot.picture = placed.shot.item.core.max;
        return placed;
    }

    PlanRequest request_of_shown() const {
        PlanRequest request;
        for (const PlacedShot& placed : shown_)
            request.items.push_back({.item = placed.shot.item, .previous = placed.placement});
        return request;
    }

    Shots laid_out(Shots wall, PlanRequest request) {
        request.canvas = canvas_;
        request.seed = seed_++;
        request.budget = 60'000;
        const Layout layout = plan(request);
        for (std::size_t i = 0; i < wall.size(); ++i)
            wall[i].placement = layout.placements[i];
        give_cells(wall, canvas_, style_);
        return wall;
    }

    Vec2 canvas_;
    Random random_;
    std::uint64_t seed_;
    DrawItems draw_;
    CellStyle style_;
    SourceId last_ = 0;
    Shots shown_;
};

}  // namespace vitrine::player
