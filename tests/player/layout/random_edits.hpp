#pragma once

#include "player/layout/pack/overlap.hpp"
#include "player/layout/plan/plan.hpp"
#include "tests/player/layout/instances.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace vitrine::player {

/// A wall on which everything is changed at random, one edit at a time, through plan(). All edits of a seed
/// are the same everywhere.
class RandomEdits {
  public:
    explicit RandomEdits(std::uint64_t seed, std::int64_t budget = 400)
        : random_(seed), request_{.canvas = {1280, 720}, .seed = seed, .budget = budget, .max_scale = 4} {
        for (int k = 0; k < 4; ++k)
            request_.items.push_back({.item = random_item(random_)});
        keep(plan(request_));
    }

    /// One edit. @return what is wrong with the layout after it; none: nothing
    std::optional<std::string> step() {
        for (PlanItem& item : request_.items)
            item.is_pinned = false;
        const std::string what = edit();
        const Layout layout = plan(request_);
        const std::string wrong = fault(layout);
        const bool is_told = !wrong.empty();
        keep(layout);
        if (is_told) return what + ": " + wrong;
        return std::nullopt;
    }

    const PlanRequest& request() const { return request_; }

    const Layout& layout() const { return layout_; }

  private:
    std::size_t any() { return uniform_index(random_, request_.items.size()); }

    std::string edit() {
        constexpr std::size_t max_count = 6;
        const std::size_t count = request_.items.size();
        request_.seed = random_();
        switch (uniform_index(random_, 8)) {
        case 0:
            if (count < max_count) request_.items.push_back({.item = random_item(random_)});
            return "insert";
        case 1:
            if (count > 1) request_.items.erase(request_.items.begin() + static_cast<std::ptrdiff_t>(any()));
            return "delete";
        case 2:
            return replace(any());
        case 3:
            return drag(any());
        case 4:
            request_.items[any()].item.weight = 0.25 + 3 * uniform(random_);
            return "weigh";
        case 5:
            return resize(any());
        case 6:
            request_.canvas = {500 + 1500 * uniform(random_), 300 + 1000 * uniform(random_)};
            if (uniform_index(random_, 2) == 0) request_.canvas = {1280, 720};
            return "change the screen";
        default:
            request_.order = request_.order == LayoutOrder::free && uniform_index(random_, 3) == 0
                                 ? LayoutOrder::reading
                                 : LayoutOrder::free;
            return "change the order";
        }
    }

    std::string replace(std::size_t item) {
        const Seat seat = seat_of(request_.items[item].item, *request_.items[item].previous);
        request_.items[item] = {.item = random_item(random_), .seat = seat};
        return "replace";
    }

    /// Puts an item where a finger might, inside the canvas, perhaps right on another.
    std::string drag(std::size_t item) {
        PlanItem& dragged = request_.items[item];
        Placement& at = *dragged.previous;
        const Box box = bounding_box(placed_region(dragged.item, at));
        const Vec2 room = request_.canvas - Vec2{2, 2} - (box.max - box.min);
        if (room.x <= 0 || room.y <= 0) return "drag nothing";
        const double x = 1 + room.x * uniform(random_);
        at.offset = at.offset + Vec2{x, 1 + room.y * uniform(random_)} - box.min;
        dragged.is_pinned = true;
        return "drag";
    }

    std::string resize(std::size_t item) {
        PlanItem& resized = request_.items[item];
        const Seat seat = seat_of(resized.item, *resized.previous);
        resized.previous.reset();
        resized.seat = Seat{seat.centre, seat.area * (0.3 + 2 * uniform(random_))};
        return "resize";
    }

    /// Exact, on the integer grid.
    std::string fault(const Layout& layout) const {
        if (layout.placements.size() != request_.items.size()) return "items are missing";
        std::vector<GridPolygon> regions;
        for (std::size_t i = 0; i < request_.items.size(); ++i)
            regions.push_back(snapped(placed_region(request_.items[i].item, layout.placements[i])));
        const UnionArea areas(std::move(regions));
        if (areas.overlap() != 0) return "regions overlap";
        const Box bounds = areas.bounds();
        const bool is_inside = bounds.min.x >= 0 && bounds.min.y >= 0 && bounds.max.x <= layout.canvas.x &&
                               bounds.max.y <= layout.canvas.y;
        return is_inside ? "" : "a region leaves the canvas";
    }

    void keep(const Layout& layout) {
        layout_ = layout;
        for (std::size_t i = 0; i < request_.items.size(); ++i) {
            request_.items[i].previous = layout.placements[i];
            request_.items[i].seat.reset();
        }
    }

    Random random_;
    PlanRequest request_;
    Layout layout_;
};

}  // namespace vitrine::player
