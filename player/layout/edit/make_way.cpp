#include "player/layout/edit/make_way.hpp"

#include "player/layout/edit/edit_window.hpp"
#include "player/layout/pack/energy.hpp"
#include "player/layout/plan/bands.hpp"
#include "player/layout/plan/motion.hpp"
#include "player/layout/plan/plan_by_outputs.hpp"
#include "player/layout/plan/plan_request.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double max_way = 0.25;  // share of the canvas' diagonal that an item moves for another at most
constexpr double near = 0.05;     // share of the diagonal that an item moves at most after it was let go
constexpr double smaller = 0.85;  // factor of a wish's scale without room
constexpr int tries = 8;          // sizes of the wishes
constexpr double band_clearance = 1.0 / 32;  // canvas px between what rests and the edge of an output

Vec2 place_of(const LayoutItem& item, const Placement& at) {
    return seat_of(item, at).centre;
}

/// The placement at this scale whose centroid is that of another placement.
Placement scaled_about(const LayoutItem& item, const Placement& at, double scale) {
    const Vec2 place = place_of(item, at);
    return {scale, place - (place - at.offset) * (scale / at.scale)};
}

/// The placement, moved so that its region lies inside a part of the canvas, and smaller if it is too large.
Placement kept_inside(const LayoutItem& item, Placement at, const Box& part, double margin) {
    const Box whole = box_of(item, at);
    const double fits =
        std::min((part.width() - 2 * margin) / whole.width(), (part.height() - 2 * margin) / whole.height());
    if (fits < 1) at = scaled_about(item, at, at.scale * fits);
    at.offset = at.offset - part.min;
    at = moved_inside(item, at, part.max - part.min, margin);
    at.offset = at.offset + part.min;
    return at;
}

/// The part of the canvas in which a wish is heard: what rests stays on one output.
Box part_for(const WallState& wall, const Wish& wish) {
    if (wish.is_in_hand || wall.canvas.bands.empty()) return {{0, 0}, wall.canvas};
    return output_of(wall.canvas, box_of(wall.items[wish.item], wish.at));
}

bool is_on_one_of(const std::vector<Wish>& wishes, const WallState& wall, const Wish& wish,
                  double clearance) {
    const LayoutItem& item = wall.items[wish.item];
    return std::ranges::any_of(wishes, [&](const Wish& other) {
        return !overlap_interval({item, wish.at, wish.at}, {wall.items[other.item], other.at, other.at},
                                 clearance)
                    .is_empty();
    });
}

/// The wishes that can be heard together, at a share of their sizes. One that is on an earlier one becomes
/// smaller.
std::vector<Wish> heard(const WallState& wall, std::span<const Wish> wishes, double size,
                        const EditRules& rules) {
    constexpr double sizes[] = {1, 0.9, 0.8, 0.65, 0.5};
    std::vector<Wish> all;
    for (const Wish& wish : wishes) {
        const LayoutItem& item = wall.items[wish.item];
        for (const double own : sizes) {
            Wish given = wish;
            const bool is_bounded = !wish.is_in_hand && !wall.canvas.bands.empty();
            given.at =
                kept_inside(item, scaled_about(item, wish.at, wish.at.scale * size * own),
                            part_for(wall, wish), std::max(rules.margin, is_bounded ? band_clearance : 0));
            if (is_on_one_of(all, wall, given, rules.clearance)) continue;
            all.push_back(given);
            break;
        }
    }
    return all;
}

/// The wall with all items at home but those with wishes, as a request in which those are pinned. The picture
/// of one in a hand is drawn above the wall: the others shall fill the canvas without it.
PlanRequest request_of(const WallState& wall, std::span<const Wish> wishes, const EditRules& rules) {
    PlanRequest request{.canvas = wall.canvas,
                        .seed = rules.seed,
                        .budget = rules.budget,
                        .clearance = rules.clearance,
                        .margin = rules.margin,
                        .max_scale = rules.max_scale,
                        .is_coarse = true};  // fine steps at every step of a finger would make items tremble
    for (std::size_t i = 0; i < wall.items.size(); ++i)
        request.items.push_back({.item = wall.items[i], .previous = wall.homes[i], .home = wall.homes[i]});
    for (const std::size_t pinned : wall.pinned)
        request.items[pinned].is_pinned = true;
    for (const Wish& wish : wishes) {
        PlanItem& item = request.items[wish.item];
        item.previous = item.home = wish.at;
        item.is_pinned = true;
        if (!wish.is_let_go) item.item.core = bounding_box(item.item.region);
    }
    return request;
}

Box window_of(const WallState& wall, std::span<const Wish> wishes, const EditRules& rules) {
    Box window;
    for (const Wish& wish : wishes) {
        const LayoutItem& item = wall.items[wish.item];
        const Box both = united(window_at(wall, place_of(item, wish.at), rules),
                                window_at(wall, place_of(item, wall.homes[wish.item]), rules));
        window = window.is_empty() ? both : united(window, both);
    }
    return window;
}

bool is_sound(const WallState& wall, const Layout& layout, std::span<const Wish> wishes) {
    const auto is_in_hand = [&](std::size_t item) {
        return std::ranges::any_of(wishes,
                                   [&](const Wish& wish) { return wish.item == item && wish.is_in_hand; });
    };
    for (std::size_t i = 0; i < wall.items.size(); ++i)
        if (is_under_band(wall.canvas, wall.items[i], layout.placements[i]) && !is_in_hand(i)) return false;
    const Measure measure = measured(wall.items, layout.placements);
    return measure.hidden == 0 && is_box_within(measure.bounds, {{0, 0}, layout.canvas});
}

/// @param farthest  share of the canvas' diagonal that an item without a wish moves from its home at most
bool is_local(const WallState& wall, const Layout& layout, std::span<const Wish> wishes,
              double farthest = max_way) {
    const double limit = farthest * length(wall.canvas);
    for (std::size_t i = 0; i < wall.items.size(); ++i) {
        if (std::ranges::find(wishes, i, &Wish::item) != wishes.end()) continue;
        const Vec2 way =
            place_of(wall.items[i], layout.placements[i]) - place_of(wall.items[i], wall.homes[i]);
        if (length(way) > limit) return false;
    }
    return true;
}

/// The layout that a plan finds for the wishes. None: there is no room for them. On a wall with much empty
/// room a plan that fills it takes the others too far away. Then one that keeps their sizes is tried, and at
/// last the others stay where they are.
std::optional<Layout> planned(const WallState& wall, std::span<const Wish> wishes, const EditRules& rules) {
    PlanRequest request = request_of(wall, wishes, rules);
    for (const bool fills : {true, false}) {
        request.fills = fills;
        auto layout = planned_in(window_of(wall, wishes, rules), request, {.should_stop = rules.should_stop});
        if (layout && is_sound(wall, *layout, wishes) && is_local(wall, *layout, wishes)) return layout;
    }
    Layout unmoved{.canvas = wall.canvas, .placements = wall.homes};
    for (const Wish& wish : wishes)
        unmoved.placements[wish.item] = wish.at;
    return is_sound(wall, unmoved, wishes) ? std::optional(unmoved) : std::nullopt;
}

/// Lets the items that were let go grow where they are, to the size that they had at home or less.
Layout grown_in_place(const WallState& wall, const Layout& layout, std::span<const Wish> wishes,
                      const EditRules& rules) {
    constexpr double sizes[] = {1, 0.93, 0.87, 0.81};
    for (const double size : sizes) {
        std::vector<Wish> grown(wishes.begin(), wishes.end());
        for (Wish& wish : grown)
            if (wish.is_let_go)
                wish.at = scaled_about(wall.items[wish.item], wish.at,
                                       std::max(wish.at.scale, wall.homes[wish.item].scale * size));
        const std::vector<Wish> given = heard(wall, grown, 1, rules);
        if (given.size() < wishes.size()) continue;
        if (auto found = planned(wall, given, rules)) return *found;
    }
    return layout;
}

/// True if all items that were let go are near the places that they have in another layout.
/// @param limit  share of the canvas' diagonal
bool keeps_let_go(const WallState& wall, const Layout& layout, const Layout& other,
                  std::span<const Wish> wishes, double limit) {
    return std::ranges::all_of(wishes, [&](const Wish& wish) {
        const LayoutItem& item = wall.items[wish.item];
        const Vec2 way =
            place_of(item, layout.placements[wish.item]) - place_of(item, other.placements[wish.item]);
        return !wish.is_let_go || length(way) <= limit * length(wall.canvas);
    });
}

/// The search for a layout in which all items are as large as they were and pictures fill the canvas, after
/// some were let go.
class Settling {
  public:
    /// @param made  in it the wishes have room; it is the result where nothing better is found
    Settling(const WallState& wall, const Layout& made, std::span<const Wish> wishes, const EditRules& rules)
        : wall_(wall),
          made_(made),
          wishes_(wishes),
          rules_(rules),
          costs_(request_of(wall, {}, rules)),
          good_enough_(cost_of_plan(costs_, {.canvas = wall.canvas, .placements = wall.homes}) + slack),
          best_(grown_in_place(wall, made, wishes, rules)) {}

    /// First all grow from where they are. Those that were let go stay near their places, or exactly there.
    /// If an item remains small in a corner then, or a part of the canvas is left open, the others make way
    /// anew: from where they grew to if nothing stays, and from their homes. At last those that were let go
    /// may move a little farther, and on a wall of few items they may take each other's places.
    Layout best() {
        const Layout begin = best_;
        if (is_better_grown(begin, false)) return best_;
        const Layout free = last_.value_or(begin);
        if (is_better_grown(begin, true)) return best_;
        for (const double size : {1.0, 0.8, 0.6, 0.45}) {
            if (is_better_anew(free.placements, size)) return best_;
            if (is_better_anew(wall_.homes, size)) return best_;
        }
        near_ = loosely_near;
        last_ = free;
        if (is_last_better()) return best_;
        take_if_closes_hole(far_);
        const bool is_free = std::ranges::all_of(wishes_, &Wish::is_let_go);
        if (is_few() && is_free && cost_of_plan(costs_, best_) > good_enough_) {
            try_exchanges();
            take_if_closes_hole(farthest_);
        }
        return best_;
    }

  private:
    static constexpr double slack = 0.1;          // of the cost over that of the wall before
    static constexpr double loosely_near = 0.15;  // share of the diagonal
    static constexpr double loosely_local = 0.4;  // share of the diagonal
    static constexpr double hole = 0.6;           // cost of a fifth of the canvas without a picture
    static constexpr double band = 0.08;          // the same of a fortieth
    static constexpr std::size_t few = 8;         // items: pictures so large leave broad bands
    static constexpr double near_of_few = 0.3;    // share of the diagonal
    static constexpr double anywhere = 1;         // share of the diagonal

    /// A layout in which items move farther than they should.
    struct Farther {
        Layout layout{};
        double cost = std::numeric_limits<double>::infinity();
    };

    /// @return true: the best layout is good enough now
    bool is_better_grown(const Layout& begin, bool is_kept) {
        WallState now = wall_;
        now.homes = begin.placements;
        PlanRequest request = request_of(now, {}, rules_);
        for (std::size_t i = 0; i < wall_.items.size(); ++i)
            request.items[i].home = scaled_about(wall_.items[i], begin.placements[i], wall_.homes[i].scale);
        for (const Wish& wish : wishes_)
            request.items[wish.item].is_pinned = is_kept || !wish.is_let_go;
        return is_better(now, std::move(request));
    }

    /// @param from  places of the others
    /// @param size  of those that were let go, of their sizes there
    bool is_better_anew(const std::vector<Placement>& from, double size) {
        std::vector<Wish> sized(wishes_.begin(), wishes_.end());
        for (Wish& wish : sized)
            if (wish.is_let_go)
                wish.at = scaled_about(wall_.items[wish.item], made_.placements[wish.item],
                                       from[wish.item].scale * size);
        const std::vector<Wish> given = heard(wall_, sized, 1, rules_);
        if (given.size() < wishes_.size()) return false;
        WallState now = wall_;
        now.homes = from;
        PlanRequest request = request_of(now, given, rules_);
        for (std::size_t i = 0; i < wall_.items.size(); ++i)
            if (!request.items[i].is_pinned) request.items[i].home = wall_.homes[i];
        return is_better(now, std::move(request));
    }

    bool is_better(const WallState& from, PlanRequest request) {
        request.is_coarse = false;
        last_ = planned_in(window_of(from, wishes_, rules_), request, {.should_stop = rules_.should_stop});
        note_far();
        return is_last_better();
    }

    bool is_last_better() {
        if (last_ && is_sound(wall_, *last_, wishes_) && is_local(wall_, *last_, wishes_) &&
            keeps_let_go(wall_, *last_, made_, wishes_, near_)) {
            const double cost = cost_of_plan(costs_, *last_);
            if (!cost_ || cost < *cost_) {
                best_ = *last_;
                cost_ = cost;
            }
        }
        return cost_ && *cost_ <= good_enough_;
    }

    /// Notes the last layout where it is the best of those in which items move so far.
    void note_far() {
        if (!last_ || !is_sound(wall_, *last_, wishes_)) return;
        const double cost = cost_of_plan(costs_, *last_);
        const bool is_far = cost < far_.cost && moves_within(loosely_local, loosely_near);
        const bool is_farthest = is_few() && cost < farthest_.cost && moves_within(anywhere, near_of_few);
        if ((!is_far && !is_farthest) || !has_way()) return;
        if (is_far) far_ = {*last_, cost};
        if (is_farthest) farthest_ = {*last_, cost};
    }

    /// @param others, let_go  shares of the diagonal: bounds for the ways of both in the last layout
    bool moves_within(double others, double let_go) const {
        return is_local(wall_, *last_, wishes_, others) &&
               keeps_let_go(wall_, *last_, made_, wishes_, let_go);
    }

    /// True if all items have a way from where the wishes got room to the last layout.
    bool has_way() const {
        return motion_between(wall_.items, made_.placements, last_->placements, wall_.canvas).has_value();
    }

    bool is_few() const { return wall_.items.size() <= few; }

    void take_if_closes_hole(const Farther& found) {
        const double gain = is_few() ? band : hole;
        if (found.cost + gain < cost_of_plan(costs_, best_)) best_ = found.layout;
    }

    /// True for an item that nobody holds or has pinned.
    bool may_go(std::size_t item) const {
        return std::ranges::find(wishes_, item, &Wish::item) == wishes_.end() &&
               std::ranges::find(wall_.pinned, item) == wall_.pinned.end();
    }

    /// One that was let go takes the place of another, which gets the place that is free then.
    void try_exchanges() {
        for (const Wish& wish : wishes_) {
            for (std::size_t other = 0; other < wall_.items.size(); ++other) {
                if (!may_go(other)) continue;
                WallState now = wall_;
                now.homes[wish.item] = placed_at(wish.item, place_of(wall_.items[other], wall_.homes[other]));
                now.homes[other] = placed_at(other, place_of(wall_.items[wish.item], wall_.homes[wish.item]));
                is_better(now, request_of(now, {}, rules_));
            }
        }
    }

    /// An item in the size that it has at home, elsewhere.
    Placement placed_at(std::size_t item, Vec2 place) const {
        Placement at = wall_.homes[item];
        at.offset = at.offset + place - place_of(wall_.items[item], at);
        return kept_inside(wall_.items[item], at, {{0, 0}, wall_.canvas}, rules_.margin);
    }

    const WallState& wall_;
    const Layout& made_;
    std::span<const Wish> wishes_;
    const EditRules& rules_;
    PlanRequest costs_;
    double good_enough_;
    Layout best_;
    std::optional<double> cost_;  // of the best one; none: it is only grown in place
    std::optional<Layout> last_;  // the last one that was tried
    double near_ = near;
    Farther far_;       // the best one in which others move too far
    Farther farthest_;  // the same on a wall of few: all may go to other places
};

}  // namespace

WallState made_way(const WallState& wall, std::span<const Wish> wishes, const EditRules& rules) {
    WallState next = wall;
    next.placements = wall.homes;
    if (wishes.empty()) return next;
    double size = 1;
    for (int k = 0; k < tries; ++k, size *= smaller) {
        const std::vector<Wish> given = heard(wall, wishes, size, rules);
        const auto layout = planned(wall, given, rules);
        if (!layout) continue;
        next.placements = layout->placements;
        if (std::ranges::none_of(given, &Wish::is_let_go)) return next;
        next.placements = next.homes = Settling(wall, *layout, given, rules).best().placements;
        return next;
    }
    return next;
}

}  // namespace vitrine::player
