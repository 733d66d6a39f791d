#pragma once

#include "player/layout/edit/make_way.hpp"
#include "player/layout/plan/bands.hpp"
#include "player/layout/plan/plan.hpp"
#include "tests/player/layout/instances.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace vitrine::player {

/// Outputs at random: two or three beside each other, a grid, or of different heights; bezels from a hair to
/// wider than items.
inline Canvas random_outputs(Random& random) {
    const auto between = [&](double min, double max) { return min + (max - min) * uniform(random); };
    const double gap = uniform_index(random, 4) == 0 ? between(60, 500) : between(1, 60);
    const Vec2 size{between(300, 900), between(200, 700)};
    std::vector<Box> outputs;
    Vec2 at;
    const std::size_t kind = uniform_index(random, 4);
    const std::size_t columns = kind == 2 ? 2 : 2 + uniform_index(random, 2);
    for (std::size_t row = 0; row < (kind == 2 ? 2 : 1); ++row, at = {0, at.y + size.y + gap})
        for (std::size_t column = 0; column < columns; ++column) {
            const double share = kind == 3 ? between(0.5, 1) : 1;
            const Vec2 own = size * share;
            const Vec2 down{0, (size.y - own.y) * (kind == 3 ? uniform(random) : 0)};
            outputs.push_back({at + down, at + down + own});
            at.x += own.x + gap;
        }
    Box all = outputs.front();
    for (const Box& output : outputs)
        all = united(all, output);
    for (Box& output : outputs)
        output = moved(output, all.min * -1);
    return canvas_of(all.max - all.min, std::move(outputs));
}

/// Walls over several outputs that are planned and edited at random: through plan() with newcomers,
/// exchanges, folders, other canvases and both orders; through made_way() by fingers that drop and enlarge
/// items.
class BandedEdits {
  public:
    explicit BandedEdits(std::uint64_t seed, std::int64_t budget = 400)
        : random_(seed), request_{.seed = seed, .budget = budget, .max_scale = 4} {
        request_.canvas = random_outputs(random_);
        const std::size_t count = 1 + uniform_index(random_, 9);
        for (std::size_t k = 0; k < count; ++k)
            request_.items.push_back({.item = random_item(random_)});
        if (uniform_index(random_, 4) == 0) group();
        planned_ = plan(request_);
    }

    /// One plan or edit. @return what is wrong after it; none: nothing
    std::optional<std::string> step() {
        keep();
        const std::string what = uniform_index(random_, 3) == 0 ? touch() : change();
        const double hidden = under_bands();
        if (hidden == 0 && is_inside()) return std::nullopt;
        return fmt::format("{}: {} px^2 of regions under bands{}", what, hidden,
                           is_inside() ? "" : ", a region beyond the canvas");
    }

    /// Area of all I-Regions under bands, canvas px^2; each band counts.
    double under_bands() const {
        double sum = 0;
        for (std::size_t i = 0; i < request_.items.size(); ++i)
            for (const Box& band : request_.canvas.bands)
                sum += area(clipped(placed_region(request_.items[i].item, planned_.placements[i]), band));
        return sum;
    }

    const PlanRequest& request() const { return request_; }

    const Layout& layout() const { return planned_; }

  private:
    std::size_t any() { return uniform_index(random_, request_.items.size()); }

    bool is_inside() const {
        for (std::size_t i = 0; i < request_.items.size(); ++i) {
            const Box box = bounding_box(placed_region(request_.items[i].item, planned_.placements[i]));
            const double slack = 1.0 / 512;
            if (box.min.x < -slack || box.min.y < -slack || box.max.x > request_.canvas.x + slack ||
                box.max.y > request_.canvas.y + slack)
                return false;
        }
        return true;
    }

    /// Puts the items into folders.
    void group() {
        const int folders = 1 + static_cast<int>(uniform_index(random_, 3));
        for (PlanItem& item : request_.items)
            item.group = static_cast<int>(uniform_index(random_, static_cast<std::size_t>(folders) + 1)) - 1;
    }

    void keep() {
        for (std::size_t i = 0; i < request_.items.size(); ++i) {
            request_.items[i].previous = planned_.placements[i];
            request_.items[i].seat.reset();
        }
    }

    std::string change() {
        request_.seed = random_();
        const std::string what = edit();
        planned_ = plan(request_);
        return what;
    }

    std::string edit() {
        constexpr std::size_t max_count = 12;
        const std::size_t count = request_.items.size();
        switch (uniform_index(random_, 7)) {
        case 0:
            if (count < max_count) request_.items.push_back({.item = random_item(random_)});
            return "insert";
        case 1:
            if (count > 1) request_.items.erase(request_.items.begin() + static_cast<std::ptrdiff_t>(any()));
            return "delete";
        case 2: {
            PlanItem& item = request_.items[any()];
            const Seat seat = seat_of(item.item, *item.previous);
            item = {.item = random_item(random_), .seat = seat, .group = item.group};
            return "replace";
        }
        case 3:
            request_.canvas = random_outputs(random_);
            return "place the outputs elsewhere";
        case 4:
            group();
            return "group";
        case 5:
            for (PlanItem& item : request_.items)
                item.previous.reset();
            return "plan anew";
        default:
            request_.order = uniform_index(random_, 3) == 0 ? LayoutOrder::reading : LayoutOrder::free;
            return "change the order";
        }
    }

    /// A finger drops an item anywhere, or one becomes large in its place while another is in a hand. After
    /// the hand has let go of it, nothing rests under a band.
    std::string touch() {
        std::vector<LayoutItem> items;
        for (const PlanItem& item : request_.items)
            items.push_back(item.item);
        const WallState wall = [&] {
            WallState state = wall_state(items, planned_);
            state.canvas = request_.canvas;
            return state;
        }();
        const EditRules rules{.seed = random_(), .budget = 2'000, .max_scale = 4};
        Wish wish{.item = any(), .at = {}, .is_let_go = true};
        wish.at = planned_.placements[wish.item];
        const Vec2 place = seat_of(items[wish.item], wish.at).centre;
        const Vec2 to{request_.canvas.x * uniform(random_), request_.canvas.y * uniform(random_)};
        wish.at.offset = wish.at.offset + to - place;
        if (uniform_index(random_, 3) == 0) {
            wish.at = planned_.placements[wish.item];
            const double growth = 1 + 1.5 * uniform(random_);
            wish.at = {wish.at.scale * growth, place - (place - wish.at.offset) * growth};
            wish.is_let_go = false;
        }
        planned_.placements = made_way(wall, {&wish, 1}, rules).placements;
        return wish.is_let_go ? "drop" : "enlarge";
    }

    Random random_;
    PlanRequest request_;
    Layout planned_;
};

}  // namespace vitrine::player
