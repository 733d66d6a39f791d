#pragma once

#include "player/layout/plan/plan.hpp"
#include "player/scene/wall_cells.hpp"
#include "tests/player/layout/instances.hpp"
#include "tests/player/scene/touched_house.hpp"

#include <algorithm>
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

    /// @param budget  of each plan
    ChangingWall(Vec2 canvas, std::size_t count, std::uint64_t seed, DrawItems draw = random_item,
                 const CellStyle& style = {}, std::int64_t budget = 60'000)
        : canvas_(canvas),
          random_(seed),
          seed_(seed),
          draw_(std::move(draw)),
          style_(style),
          budget_(budget) {
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

    /// Fingers take shots to any places and drop them there, all at once. The wall at the end becomes the
    /// shown one.
    /// @param on_frame  gets each frame until all is in its place
    void drag(int hands, const std::function<void(const TouchedHouse& house, const Frame& frame)>& on_frame) {
        constexpr int moving = 12;   // frames
        constexpr int resting = 10;  // frames
        constexpr int longest = 200;
        TouchedHouse house(shown_, canvas_);
        house.touch = WallTouch({.edits = {.seed = seed_++, .budget = 20'000}, .cells = style_});
        std::vector<Vec2> from;
        std::vector<Vec2> to;
        for (int hand = 0; hand < hands; ++hand) {
            const PlacedShot& held = shown_[uniform_index(random_, shown_.size())];
            from.push_back(player::seat_of(held.shot.item, held.placement).centre);
            const double x = uniform(random_);
            to.push_back({canvas_.x * x, canvas_.y * uniform(random_)});
            house.put(Contact::Kind::down, hand, from.back());
        }
        for (int k = 1; k <= moving + resting; ++k) {
            const double share = std::min(1.0, k / double{moving});
            for (int hand = 0; hand < hands && k <= moving; ++hand) {
                const auto number = static_cast<std::size_t>(hand);
                house.put(Contact::Kind::move, hand, from[number] + (to[number] - from[number]) * share);
            }
            on_frame(house, house.frame());
        }
        for (int hand = 0; hand < hands; ++hand)
            house.put(Contact::Kind::up, hand);
        for (int k = 0; k < longest && (k == 0 || house.touch.is_active() || house.change || house.next); ++k)
            on_frame(house, house.frame());
        shown_ = house.wall;
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
        request.budget = budget_;
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
    std::int64_t budget_;
    SourceId last_ = 0;
    Shots shown_;
};

}  // namespace vitrine::player
