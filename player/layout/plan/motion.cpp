#include "player/layout/plan/motion.hpp"

#include "player/layout/pack/shape.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

// Straight motion is free of overlap for most small changes. If it is not, mostly an item moves to a place
// where another one still is: then that other one moves first. Items that would pass through each other
// become smaller until they do not meet; a convex region that shrinks about an inner point stays within
// itself, so shrinking is always free. Items that change places move by way of a halfway layout, in which
// conflicts are pushed apart sideways. Of these the calmer one is taken.

namespace vitrine::player {

namespace {

using Placements = std::vector<Placement>;

constexpr double apart = 1.0 / 128;  // canvas px; more than the rounding by the grid of exact areas
constexpr std::size_t max_stages = 4;
constexpr double shrink = 0.94;                            // factor of each try
constexpr std::array halfway_factors{1.0, 0.9, 0.8, 0.7};  // times the smaller of both scales
constexpr int max_pushes = 60;  // rounds of pushing items apart at the halfway layout

double support(const Polygon& outline, Vec2 direction) {
    double largest = -std::numeric_limits<double>::infinity();
    for (const Vec2& p : outline)
        largest = std::max(largest, dot(p, direction));
    return largest;
}

Placement mixed(const Placement& a, const Placement& b, double t) {
    return {a.scale * (1 - t) + b.scale * t, a.offset * (1 - t) + b.offset * t};
}

/// A moving region. Its outline is in source px; both placements map it to the canvas.
struct MovingRegion {
    const Polygon& outline;
    Placement from, to;
};

/// Limits `inside` to the times at which the gap along the outward normals of a's sides is negative.
void cut_by_sides(const MovingRegion& a, const MovingRegion& b, double clearance, OverlapInterval& inside) {
    for (std::size_t k = 0; k < a.outline.size() && !inside.is_empty(); ++k) {
        const Vec2 edge = a.outline[(k + 1) % a.outline.size()] - a.outline[k];
        if (edge == Vec2{}) continue;
        const Vec2 n = Vec2{edge.y, -edge.x} * (1 / length(edge));
        const double first = support(a.outline, n);
        const double second = support(b.outline, n * -1);
        const auto gap = [&](const Placement& at, const Placement& other) {
            return dot(n, other.offset - at.offset) - at.scale * first - other.scale * second - clearance;
        };
        const double begin = gap(a.from, b.from);
        const double end = gap(a.to, b.to);
        if (begin >= 0 && end >= 0) inside = {};
        if (begin >= 0 && end < 0) inside.begin = std::max(inside.begin, begin / (begin - end));
        if (begin < 0 && end >= 0) inside.end = std::min(inside.end, begin / (begin - end));
    }
}

OverlapInterval overlap_of(const MovingRegion& a, const MovingRegion& b, double clearance) {
    OverlapInterval inside{0, 1};
    cut_by_sides(a, b, clearance, inside);
    if (!inside.is_empty()) cut_by_sides(b, a, clearance, inside);
    return inside;
}

Box placed(const Box& box, const Placement& at) {
    return {box.min * at.scale + at.offset, box.max * at.scale + at.offset};
}

bool are_apart(const Box& a, const Box& b) {
    return a.max.x + apart <= b.min.x || b.max.x + apart <= a.min.x || a.max.y + apart <= b.min.y ||
           b.max.y + apart <= a.min.y;
}

/// Searches a motion of some items.
class MotionSearch {
  public:
    MotionSearch(std::span<const LayoutItem> items, std::span<const Placement> from,
                 std::span<const Placement> to, Vec2 canvas)
        : canvas_(canvas), from_(from.begin(), from.end()), to_(to.begin(), to.end()) {
        for (const LayoutItem& item : items) {
            const Shape shape = shape_of(item.region);
            centroids_.push_back(shape.centroid);
            outlines_.push_back(transformed(shape.outline, 1, shape.centroid));
            extents_.push_back(moved(shape.extent, shape.centroid));
        }
    }

    std::optional<Motion> run() const {
        if (from_ == to_) return Motion{Motion::Kind::still, {to_}};
        if (!is_free(from_, from_) || !is_free(to_, to_)) return std::nullopt;
        if (is_free(from_, to_)) return Motion{Motion::Kind::straight, {from_, to_}};
        if (auto found = staged()) return found;
        return calmest();
    }

  private:
    bool is_free(const Placements& a, const Placements& b) const {
        const std::vector<bool> in_conflict = conflicts(a, b);
        return std::find(in_conflict.begin(), in_conflict.end(), true) == in_conflict.end();
    }

    /// Returns the calmest of the motions that make some items smaller or lead through a halfway layout.
    /// None: there is no such motion.
    std::optional<Motion> calmest() const {
        constexpr std::size_t keys_of_detour = 3;  // at least
        std::optional<Motion> best;
        double calm = 0;
        const auto compare = [&](std::optional<Motion> other) {
            if (!other) return;
            const double scale = smallest_scale(*other);
            const double value = calmness(scale, other->keys.size());
            if (scale < min_scale_on_way || (best && value <= calm)) return;
            best = std::move(other);
            calm = value;
        };
        if (auto keys = shrunk(from_, to_)) compare(Motion{Motion::Kind::shrunk, std::move(*keys)});
        for (const double factor : halfway_factors)
            if (!best || calmness(factor, keys_of_detour) > calm) compare(detour(factor));
        return best;
    }

    /// A motion is calm where the items stay large and stop seldom.
    static double calmness(double smallest, std::size_t keys) {
        constexpr double cost_of_stop = 0.03;  // of the scale
        return smallest - cost_of_stop * static_cast<double>(keys);
    }

    std::size_t size() const { return outlines_.size(); }

    bool meet(std::size_t i, std::size_t j, const Placements& a, const Placements& b) const {
        return !overlap_of({outlines_[i], a[i], b[i]}, {outlines_[j], a[j], b[j]}, apart).is_empty();
    }

    /// For each item: true if it meets another on the straight way.
    std::vector<bool> conflicts(const Placements& a, const Placements& b) const {
        std::vector<Box> swept;
        for (std::size_t i = 0; i < size(); ++i)
            swept.push_back(united(placed(extents_[i], a[i]), placed(extents_[i], b[i])));
        std::vector<bool> found(size(), false);
        for (std::size_t i = 0; i < size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (!are_apart(swept[i], swept[j]) && meet(i, j, a, b)) found[i] = found[j] = true;
        return found;
    }

    /// Each stage moves all items that can move at once while the others stay.
    std::optional<Motion> staged() const {
        Motion motion{Motion::Kind::staged, {from_}};
        while (motion.keys.back() != to_ && motion.keys.size() <= max_stages) {
            const Placements& now = motion.keys.back();
            Placements next = now;
            for (std::size_t i = 0; i < size(); ++i) {
                next[i] = to_[i];
                for (std::size_t j = 0; j < size() && next[i] != now[i]; ++j)
                    if (j != i && meet(i, j, now, next)) next[i] = now[i];
            }
            if (next == now) return std::nullopt;
            motion.keys.push_back(next);
        }
        if (motion.keys.back() != to_) return std::nullopt;
        return motion;
    }

    /// Where an item's centroid is, canvas px.
    Vec2 place(std::size_t item, const Placement& at) const {
        return centroids_[item] * at.scale + at.offset;
    }

    Placement about_centroid(std::size_t item, const Placement& at, double scale) const {
        return {scale, place(item, at) - centroids_[item] * scale};
    }

    /// Shrinks the items that meet others, before the motion, and enlarges them again after it.
    std::optional<std::vector<Placements>> shrunk(const Placements& a, const Placements& b) const {
        std::vector<double> factors(size(), 1);
        for (;;) {
            Placements small_a = a;
            Placements small_b = b;
            for (std::size_t i = 0; i < size(); ++i) {
                if (factors[i] == 1) continue;
                const double scale = factors[i] * std::min(a[i].scale, b[i].scale);
                small_a[i] = about_centroid(i, a[i], scale);
                small_b[i] = about_centroid(i, b[i], scale);
            }
            const std::vector<bool> in_conflict = conflicts(small_a, small_b);
            if (std::find(in_conflict.begin(), in_conflict.end(), true) == in_conflict.end()) {
                std::vector<Placements> keys{a, small_a, small_b, b};
                keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
                return keys;
            }
            for (std::size_t i = 0; i < size(); ++i) {
                if (in_conflict[i]) factors[i] *= shrink;
                if (factors[i] < min_scale_on_way) return std::nullopt;
            }
        }
    }

    /// Pushes the halfway places apart until nothing overlaps. None: some still overlap after max_pushes
    /// rounds.
    /// @param factor  of the items that move, times the smaller of both scales
    std::optional<Placements> halfway(double factor) const {
        Placements middle;
        for (std::size_t i = 0; i < size(); ++i) {
            const Placement even = mixed(from_[i], to_[i], 0.5);
            const bool moves = from_[i] != to_[i];
            middle.push_back(moves ? about_centroid(i, even, factor * std::min(from_[i].scale, to_[i].scale))
                                   : even);
        }
        for (int k = 0; k < max_pushes; ++k) {
            bool is_clear = true;
            for (std::size_t i = 0; i < size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    if (meet(i, j, middle, middle)) {
                        push(i, j, middle);
                        is_clear = false;
                    }
            if (is_clear) return middle;
        }
        return std::nullopt;
    }

    Placement inside_canvas(std::size_t item, const Placement& at) const {
        const Box box = placed(extents_[item], at);
        const Vec2 low{std::max(0.0, -box.min.x), std::max(0.0, -box.min.y)};
        const Vec2 high{std::max(0.0, box.max.x - canvas_.x), std::max(0.0, box.max.y - canvas_.y)};
        return {at.scale, at.offset + low - high};
    }

    /// Moves two items apart, rather sideways than along the first one's way.
    void push(std::size_t i, std::size_t j, Placements& at) const {
        const Vec2 between = place(i, at[i]) - place(j, at[j]);
        const Vec2 way = (place(i, to_[i]) - place(i, from_[i])) - (place(j, to_[j]) - place(j, from_[j]));
        Vec2 aside{-way.y, way.x};
        if (dot(aside, between) < 0) aside = aside * -1;
        const double far = std::max(1.0, length(between));
        Vec2 direction = between * (1 / far);
        if (length(aside) > 0) direction = direction + aside * (1 / length(aside));
        const Box extent = placed(extents_[i], at[i]);
        const double step = 0.04 * (extent.width() + extent.height());
        for (const std::size_t k : {i, j}) {
            if (from_[k] == to_[k]) continue;
            at[k].offset = at[k].offset + direction * (k == i ? step : -step);
            at[k] = inside_canvas(k, at[k]);
        }
    }

    /// The places beside the straight way, as far aside as the halfway places are.
    /// @param share  of the way
    Placements beside(const Placements& middle, double share) const {
        Placements places;
        for (std::size_t i = 0; i < size(); ++i) {
            const Placement even = mixed(from_[i], to_[i], 0.5);
            const Vec2 aside = place(i, middle[i]) - place(i, even);
            Placement at = mixed(from_[i], to_[i], share);
            at.offset = at.offset + aside;
            at = about_centroid(i, at, middle[i].scale);
            places.push_back(from_[i] == to_[i] ? at : inside_canvas(i, at));
        }
        return places;
    }

    /// By way of the halfway places, or past them on parallel ways.
    std::optional<Motion> detour(double factor) const {
        const auto middle = halfway(factor);
        if (!middle) return std::nullopt;
        if (auto found = motion_through({*middle})) return found;
        constexpr double begin = 0.25;  // of the parallel ways
        return motion_through({beside(*middle, begin), beside(*middle, 1 - begin)});
    }

    /// A motion that comes to rest at these places in turn. None: one is not free, or has no free way to it.
    std::optional<Motion> motion_through(const std::vector<Placements>& places) const {
        Motion motion{Motion::Kind::detour, {from_}};
        const auto go_to = [&](const Placements& next) {
            if (!is_free(next, next)) return false;
            const auto keys = shrunk(motion.keys.back(), next);
            if (!keys) return false;
            motion.keys.insert(motion.keys.end(), keys->begin() + 1, keys->end());
            return true;
        };
        for (const Placements& next : places)
            if (!go_to(next)) return std::nullopt;
        if (!go_to(to_)) return std::nullopt;
        return motion;
    }

    Vec2 canvas_;
    Placements from_, to_;
    std::vector<Vec2> centroids_;
    std::vector<Polygon> outlines_;  // source px
    std::vector<Box> extents_;
};

}  // namespace

std::vector<Placement> placements_at(const Motion& motion, double time) {
    assert(!motion.keys.empty());
    const auto last = static_cast<double>(motion.keys.size() - 1);
    const double at = std::clamp(time, 0.0, 1.0) * last;
    const auto key = static_cast<std::size_t>(std::min(at, std::max(0.0, last - 1)));
    if (key + 1 >= motion.keys.size()) return motion.keys.back();
    Placements now;
    for (std::size_t i = 0; i < motion.keys[key].size(); ++i)
        now.push_back(mixed(motion.keys[key][i], motion.keys[key + 1][i], at - static_cast<double>(key)));
    return now;
}

double smallest_scale(const Motion& motion) {
    double smallest = 1;
    for (std::size_t i = 0; i < motion.keys.front().size(); ++i) {
        const double at_rest = std::min(motion.keys.front()[i].scale, motion.keys.back()[i].scale);
        for (const Placements& key : motion.keys)
            smallest = std::min(smallest, key[i].scale / at_rest);
    }
    return smallest;
}

OverlapInterval overlap_interval(const MovingItem& a, const MovingItem& b, double clearance) {
    return overlap_of({a.item.region, a.from, a.to}, {b.item.region, b.from, b.to}, clearance);
}

std::optional<LayoutItem> guard_of_seat(const Polygon& common, double seat_area) {
    constexpr double guard_share = 0.3;        // of the side
    constexpr double min_common_share = 0.25;  // of the area
    if (common.size() < 3) return std::nullopt;
    const double area = std::abs(signed_area(common));
    if (area < std::max(1.0, min_common_share * seat_area)) return std::nullopt;
    const Polygon middle = transformed(common, guard_share, centroid(common) * (1 - guard_share));
    return LayoutItem{.region = middle, .core = bounding_box(middle)};
}

std::vector<int> meetings(std::span<const LayoutItem> items, std::span<const Placement> from,
                          std::span<const Placement> to) {
    constexpr double clearance = 1.0 / 64;  // canvas px
    std::vector<int> counts(items.size(), -1);
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (from[i] == to[i]) continue;
        counts[i] = 0;
        for (std::size_t j = 0; j < items.size(); ++j)
            if (j != i && !overlap_interval({items[i], from[i], to[i]}, {items[j], from[j], to[j]}, clearance)
                               .is_empty())
                ++counts[i];
    }
    return counts;
}

std::optional<Motion> motion_between(std::span<const LayoutItem> items, std::span<const Placement> from,
                                     std::span<const Placement> to, Vec2 canvas) {
    assert(items.size() == from.size() && items.size() == to.size());
    return MotionSearch(items, from, to, canvas).run();
}

}  // namespace vitrine::player
