#include "player/scene/transition.hpp"

#include "player/layout/cells/grid.hpp"
#include "player/scene/crossfade.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double clearance = 1.0 / 64;  // canvas px between regions that are shrunk and others
constexpr int samples = 24;             // times at which the ways are looked at
constexpr double min_fade = 0.3;        // share of the duration

/// The farthest that a corner of a moving shot's region goes between a key and the next, canvas px.
double way_from(const Transition& transition, std::size_t key) {
    double longest = 0;
    const auto& keys = transition.motion.keys;
    for (const ChangingShot& shot : transition.old_wall) {
        if (!shot.moving) continue;
        const Placement& from = keys[key][*shot.moving];
        const Placement& to = keys[key + 1][*shot.moving];
        for (const Vec2 corner : shot.placed.shot.item.region)
            longest = std::max(longest, length(corner * (to.scale - from.scale) + to.offset - from.offset));
    }
    return longest;
}

/// The time of a motion at a share of the transition. The shots come to rest at each key. A stage from key to
/// key takes a time that grows with the root of its way, so that all stages accelerate alike.
double progress_of(const Transition& transition, double share) {
    const std::size_t stages = transition.motion.keys.size() - 1;
    if (stages < 2) return eased(share);
    std::vector<double> ends;
    for (std::size_t key = 0; key < stages; ++key)
        ends.push_back((ends.empty() ? 0 : ends.back()) + std::sqrt(way_from(transition, key)));
    if (ends.back() <= 0) return eased(share);
    const double at = std::clamp(share, 0.0, 1.0) * ends.back();
    std::size_t stage = 0;
    while (stage + 1 < stages && ends[stage] < at)
        ++stage;
    const double begin = stage == 0 ? 0 : ends[stage - 1];
    const double passed = ends[stage] > begin ? (at - begin) / (ends[stage] - begin) : 1;
    return (static_cast<double>(stage) + eased(passed)) / static_cast<double>(stages);
}

/// The middle of what the seats of two shots have in common. None: they have too little in common.
std::optional<LayoutItem> guard_of(const PlacedShot& leaving, const PlacedShot& coming) {
    const Loops before{to_grid(placed_region(leaving.shot.item, leaving.placement))};
    const Loops after{to_grid(placed_region(coming.shot.item, coming.placement))};
    const Loops common = intersection_of(before, after);
    if (common.size() != 1) return std::nullopt;
    return guard_of_seat(from_grid(common[0]), std::min(area_of(before), area_of(after)));
}

/// Points of a shot's region near its corners and near the middles of its sides.
std::vector<Vec2> points_towards_border(const PlacedShot& placed) {
    const Polygon region = placed_region(placed.shot.item, placed.placement);
    const Vec2 middle = centroid(region);
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < region.size(); ++k)
        for (const Vec2 target : {region[k], (region[k] + region[(k + 1) % region.size()]) * 0.5})
            for (const double share : {0.7, 0.9})
                points.push_back(middle + (target - middle) * share);
    return points;
}

/// Finds the parts of all shots in a transition.
class TransitionSearch {
  public:
    explicit TransitionSearch(Transition& found) : found_(found) {}

    void run() {
        for (std::size_t i = 0; i < found_.old_wall.size(); ++i)
            if (const auto j = twin_of(i)) staying_.push_back({i, *j});
        add_guards();
        while (!staying_.empty()) {
            found_.fade_begin = 0;
            found_.fade_end = 1;
            const auto motion = motion_of();
            if (motion) {
                take(*motion);
                if (motion->kind == Motion::Kind::still) break;
                choose_times();
                if (found_.fade_end - found_.fade_begin >= min_fade) return;
            }
            if (!drop_one(motion ? blocking() : conflicts())) staying_.clear();
        }
        found_.fade_begin = 0;
        found_.fade_end = 1;
        if (staying_.empty()) take({Motion::Kind::still, {{}}});
    }

  private:
    /// A shot that stays: its places in both walls.
    struct Staying {
        std::size_t before = 0;
        std::size_t after = 0;
    };

    /// The middle of the seat that a shot leaves to another one.
    struct Guard {
        LayoutItem item;
        std::size_t leaving = 0;
        std::size_t coming = 0;
    };

    const PlacedShot& before(const Staying& staying) const { return found_.old_wall[staying.before].placed; }

    const PlacedShot& after(const Staying& staying) const { return found_.new_wall[staying.after].placed; }

    std::optional<std::size_t> twin_of(std::size_t old) const {
        const SourceId source = found_.old_wall[old].placed.shot.source;
        const auto same = std::ranges::find(found_.new_wall, source,
                                            [](const ChangingShot& shot) { return shot.placed.shot.source; });
        if (same == found_.new_wall.end()) return std::nullopt;
        return static_cast<std::size_t>(same - found_.new_wall.begin());
    }

    void add_guards() {
        for (std::size_t i = 0; i < found_.old_wall.size(); ++i) {
            if (twin_of(i)) continue;
            for (std::size_t j = 0; j < found_.new_wall.size(); ++j) {
                if (found_.new_wall[j].placed.shot.slot != found_.old_wall[i].placed.shot.slot) continue;
                if (auto guard = guard_of(found_.old_wall[i].placed, found_.new_wall[j].placed))
                    guards_.push_back({std::move(*guard), i, j});
            }
        }
    }

    /// The shots that stay, then the guards, which do not move.
    struct Movable {
        std::vector<LayoutItem> items;
        std::vector<Placement> from;
        std::vector<Placement> to;
    };

    Movable movable() const {
        Movable all;
        for (const Staying& staying : staying_) {
            all.items.push_back(before(staying).shot.item);
            all.from.push_back(before(staying).placement);
            all.to.push_back(after(staying).placement);
        }
        for (const Guard& guard : guards_) {
            all.items.push_back(guard.item);
            all.from.emplace_back();
            all.to.emplace_back();
        }
        return all;
    }

    /// None: there is no free way.
    std::optional<Motion> motion_of() const {
        const Movable all = movable();
        return motion_between(all.items, all.from, all.to, found_.canvas);
    }

    void take(const Motion& motion) {
        found_.motion = motion;
        for (auto* wall : {&found_.old_wall, &found_.new_wall})
            for (ChangingShot& shot : *wall)
                shot.moving.reset();
        for (std::size_t k = 0; k < staying_.size(); ++k)
            found_.old_wall[staying_[k].before].moving = found_.new_wall[staying_[k].after].moving = k;
    }

    /// Chooses the focus of each shot that leaves or comes, and when the new wall fades in.
    void choose_times() {
        places_.clear();
        for (int k = 0; k <= samples; ++k)
            places_.push_back(placements_at(found_, k / double{samples}));
        for (auto* wall : {&found_.old_wall, &found_.new_wall})
            for (std::size_t i = 0; i < wall->size(); ++i) {
                ChangingShot& shot = (*wall)[i];
                if (shot.moving) continue;
                const bool leaves = wall == &found_.old_wall;
                choose_focus(shot, leaves, i);
                const double time = time_of(shot, leaves);
                if (leaves)
                    found_.fade_end = std::min(found_.fade_end, time);
                else
                    found_.fade_begin = std::max(found_.fade_begin, time);
            }
    }

    void choose_focus(ChangingShot& shot, bool leaves, std::size_t index) const {
        for (const Guard& guard : guards_)
            if ((leaves ? guard.leaving : guard.coming) == index) {
                shot.focus = centroid(guard.item.region);
                return;
            }
        shot.focus = centroid(placed_region(shot.placed.shot.item, shot.placed.placement));
        double best = time_of(shot, leaves);
        for (const Vec2 point : points_towards_border(shot.placed)) {
            ChangingShot other = shot;
            other.focus = point;
            const double time = time_of(other, leaves);
            if (leaves ? time <= best : time >= best) continue;
            shot.focus = point;
            best = time;
        }
    }

    /// The share of the duration at which a shot that leaves has no place any more, or from which on a shot
    /// that comes has one.
    double time_of(const ChangingShot& shot, bool leaves) const {
        const auto has_place = [&](int k) {
            return free_share(found_, shot, places_[static_cast<std::size_t>(k)]) >= min_free_share;
        };
        if (leaves) {
            int last = 0;
            while (last < samples && has_place(last + 1))
                ++last;
            return last / double{samples};
        }
        int first = samples;
        while (first > 0 && has_place(first - 1))
            --first;
        return first / double{samples};
    }

    bool moves(std::size_t k) const { return before(staying_[k]).placement != after(staying_[k]).placement; }

    /// For each shot that stays: the number of others that it meets on the straight way.
    std::vector<int> conflicts() const {
        const Movable all = movable();
        std::vector<int> counts = meetings(all.items, all.from, all.to);
        counts.resize(staying_.size());
        return counts;
    }

    /// For each shot that stays: how long it covers a focus.
    std::vector<int> blocking() const {
        std::vector<int> counts(staying_.size(), 0);
        for (const auto* wall : {&found_.old_wall, &found_.new_wall})
            for (const ChangingShot& shot : *wall) {
                if (shot.moving) continue;
                for (const std::vector<Placement>& placements : places_)
                    for (std::size_t k = 0; k < staying_.size(); ++k)
                        if (moves(k) &&
                            is_inside_convex(placed_region(before(staying_[k]).shot.item, placements[k]),
                                             shot.focus))
                            ++counts[k];
            }
        return counts;
    }

    /// Lets the shot with the largest count fade from place to place; of equal ones that with the longest
    /// way.
    bool drop_one(const std::vector<int>& counts) {
        std::optional<std::size_t> worst;
        const auto way = [&](std::size_t k) {
            return length(after(staying_[k]).placement.offset - before(staying_[k]).placement.offset);
        };
        for (std::size_t k = 0; k < staying_.size(); ++k) {
            if (!moves(k)) continue;
            if (!worst || counts[k] > counts[*worst] || (counts[k] == counts[*worst] && way(k) > way(*worst)))
                worst = k;
        }
        if (worst) staying_.erase(staying_.begin() + static_cast<std::ptrdiff_t>(*worst));
        return worst.has_value();
    }

    Transition& found_;  // outlives this
    std::vector<Staying> staying_;
    std::vector<Guard> guards_;
    std::vector<std::vector<Placement>> places_;  // of the motion, at each sample
};

std::vector<ChangingShot> changing(std::span<const PlacedShot> wall) {
    std::vector<ChangingShot> shots;
    for (const PlacedShot& placed : wall)
        shots.push_back({.placed = placed, .moving = {}, .focus = {}});
    return shots;
}

}  // namespace

Transition transition(Vec2 canvas, std::span<const PlacedShot> shown, std::span<const PlacedShot> incoming,
                      const TransitionStyle& style) {
    Transition found{.canvas = canvas,
                     .old_wall = changing(shown),
                     .new_wall = changing(incoming),
                     .motion = {Motion::Kind::still, {{}}},
                     .duration = style.duration};
    if (style.moves && style.duration.count() > 0) TransitionSearch(found).run();
    return found;
}

std::size_t wayless_count(const Transition& transition) {
    const auto is_wayless = [&](const ChangingShot& shot) {
        if (shot.moving) return false;
        return std::ranges::any_of(transition.new_wall, [&](const ChangingShot& other) {
            return other.placed.shot.source == shot.placed.shot.source &&
                   other.placed.placement != shot.placed.placement;
        });
    };
    return static_cast<std::size_t>(std::ranges::count_if(transition.old_wall, is_wayless));
}

std::vector<Placement> placements_at(const Transition& transition, double share) {
    return placements_at(transition.motion, progress_of(transition, share));
}

double free_share(const Transition& transition, const ChangingShot& shot,
                  std::span<const Placement> placements) {
    double share = 1;
    for (const ChangingShot& other : transition.old_wall) {
        if (!other.moving) continue;
        const Placement& at = placements[*other.moving];
        const OverlapInterval overlap =
            overlap_interval({shot.placed.shot.item, {0, shot.focus}, shot.placed.placement},
                             {other.placed.shot.item, at, at}, clearance);
        if (!overlap.is_empty()) share = std::min(share, overlap.begin);
    }
    return share;
}

}  // namespace vitrine::player
