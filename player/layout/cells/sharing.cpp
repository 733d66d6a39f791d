#include "player/layout/cells/sharing.hpp"

#include "base/geometry/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double whole_share = 0.004;  // share of the canvas; a smaller leftover goes to one taker as a whole
constexpr double needle_length = 32;   // canvas px: a small leftover that is longer is a needle
constexpr double needle_width = 16;    // canvas px: if it is narrower on the average, too
constexpr double needle_step = 8;      // canvas px between the places where its takers are compared
constexpr int border_halvings = 12;    // of a step: the border between two takers is exact to 1/500 px

/// A part of the canvas where the nearest item has no pixels. The takers are the items that have pixels
/// there.
struct Leftover {
    Loops area;
    std::set<std::size_t> takers;
};

void append(Loops& to, const Loops& more) {
    to.insert(to.end(), more.begin(), more.end());
}

std::vector<Vec2> corners_of(const Loops& loops) {
    std::vector<Vec2> corners;
    for (const Loop& loop : loops)
        for (const CellPoint& p : loop)
            corners.push_back(from_grid(p));
    return corners;
}

Box bounds_of_loops(const Loops& loops) {
    return bounding_box(corners_of(loops));
}

/// The corners that lie farthest apart along an axis, the lesser one first.
std::pair<Vec2, Vec2> ends_of(const Loops& loops, double Vec2::*along) {
    const std::vector<Vec2> corners = corners_of(loops);
    const auto [first, last] = std::ranges::minmax_element(corners, {}, along);
    return {*first, *last};
}

/// Splits such an area by the sets of items that have pixels.
std::vector<Leftover> split_by_takers(const Loops& orphaned, const std::vector<Loops>& cores) {
    std::vector<Leftover> leftovers;
    if (!orphaned.empty()) leftovers.push_back({orphaned, {}});
    for (std::size_t i = 0; i < cores.size(); ++i) {
        if (cores[i].empty()) continue;
        const Box core = bounds_of_loops(cores[i]);
        std::vector<Leftover> next;
        for (Leftover& leftover : leftovers) {
            const Box bounds = bounds_of_loops(leftover.area);
            if (intersection(bounds, core).is_empty()) {
                next.push_back(std::move(leftover));
                continue;
            }
            if (intersection(bounds, core) == bounds) {
                leftover.takers.insert(i);
                next.push_back(std::move(leftover));
                continue;
            }
            Loops inside = intersection_of(leftover.area, cores[i]);
            Loops outside = difference_of(leftover.area, cores[i]);
            if (!outside.empty()) next.push_back({std::move(outside), leftover.takers});
            leftover.takers.insert(i);
            if (!inside.empty()) next.push_back({std::move(inside), std::move(leftover.takers)});
        }
        leftovers = std::move(next);
    }
    return leftovers;
}

double distance(const Box& a, const Box& b) {
    return length({std::max({0.0, a.min.x - b.max.x, b.min.x - a.max.x}),
                   std::max({0.0, a.min.y - b.max.y, b.min.y - a.max.y})});
}

/// An upper bound of the distance from any point of a box to a region.
double max_distance(const Box& box, const Polygon& region) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Vec2& p : region)
        smallest = std::min(smallest, length({std::max(p.x - box.min.x, box.max.x - p.x),
                                              std::max(p.y - box.min.y, box.max.y - p.y)}));
    return smallest;
}

/// The takers that may be the nearest ones somewhere in a leftover.
std::set<std::size_t> likely_takers(const Leftover& leftover, std::span<const Polygon> regions) {
    const Box bounds = bounds_of_loops(leftover.area);
    double reach = std::numeric_limits<double>::infinity();
    for (const std::size_t taker : leftover.takers)
        reach = std::min(reach, max_distance(bounds, regions[taker]));
    std::set<std::size_t> likely;
    for (const std::size_t taker : leftover.takers)
        if (distance(bounds, bounding_box(regions[taker])) <= reach) likely.insert(taker);
    return likely;
}

/// Divides each leftover among its nearest takers.
class LeftoverSharing {
  public:
    LeftoverSharing(std::span<const Polygon> regions, const Box& canvas, const VoronoiSites& sites)
        : regions_(regions), canvas_(canvas), sites_(sites) {}

    void give(const Leftover& leftover, std::vector<Loops>& shown) {
        const std::set<std::size_t> takers = likely_takers(leftover, regions_);
        if (takers.size() == 1) return append(shown[*takers.begin()], leftover.area);
        const double area = area_of(leftover.area);
        if (area < whole_share * canvas_.area()) {
            const Box bounds = bounds_of_loops(leftover.area);
            const double length = std::max(bounds.width(), bounds.height());
            if (length > needle_length && area < needle_width * length)
                return give_along(leftover.area, takers, shown);
            return append(shown[nearest(bounds.centre(), takers)], leftover.area);
        }
        const std::vector<Loops>& diagram = diagram_of(takers);
        Loops rest = leftover.area;
        for (const std::size_t taker : takers) {
            append(shown[taker], intersection_of(leftover.area, diagram[taker]));
            rest = difference_of(rest, diagram[taker]);
        }
        append(shown[*leftover.takers.begin()], rest);  // slivers from rounding
    }

  private:
    /// Cuts a needle across, where another taker becomes the nearest. Given to one taker as a whole, it would
    /// lie along the others.
    void give_along(Loops rest, const std::set<std::size_t>& takers, std::vector<Loops>& shown) const {
        const Box bounds = bounds_of_loops(rest);
        const auto along = bounds.width() >= bounds.height() ? &Vec2::x : &Vec2::y;
        const auto [first, last] = ends_of(rest, along);
        const auto at = [first = first, last = last](double share) { return first + (last - first) * share; };
        const int steps = static_cast<int>(std::ceil((last.*along - first.*along) / needle_step));
        std::size_t taker = nearest(first, takers);
        for (int k = 1; k <= steps; ++k) {
            const std::size_t next = nearest(at(1.0 * k / steps), takers);
            if (next == taker) continue;
            double before = (k - 1.0) / steps, behind = 1.0 * k / steps;
            for (int halving = 0; halving < border_halvings; ++halving) {
                const double middle = (before + behind) / 2;
                (nearest(at(middle), takers) == taker ? before : behind) = middle;
            }
            Box part{bounds.min - Vec2{1, 1}, bounds.max + Vec2{1, 1}};
            part.max.*along = at(behind).*along;
            const Loops cut{to_grid(to_polygon(part))};
            append(shown[taker], intersection_of(rest, cut));
            rest = difference_of(rest, cut);
            taker = next;
        }
        append(shown[taker], rest);
    }

    /// The taker whose region is nearest to a place.
    std::size_t nearest(Vec2 place, const std::set<std::size_t>& takers) const {
        return *std::min_element(takers.begin(), takers.end(), [&](std::size_t a, std::size_t b) {
            return distance_to(regions_[a], place) < distance_to(regions_[b], place);
        });
    }

    /// The Voronoi diagram of some regions, with the indices of all regions.
    const std::vector<Loops>& diagram_of(const std::set<std::size_t>& some) {
        const auto known = diagrams_.find(some);
        if (known != diagrams_.end()) return known->second;
        std::vector<Polygon> regions;
        regions.reserve(some.size());
        for (const std::size_t i : some)
            regions.push_back(regions_[i]);
        std::vector<Loops> found = voronoi(regions, canvas_, sites_);
        std::vector<Loops> all(regions_.size());
        std::size_t k = 0;
        for (const std::size_t i : some)
            all[i] = std::move(found[k++]);
        return diagrams_[some] = std::move(all);
    }

    std::span<const Polygon> regions_;
    Box canvas_;
    VoronoiSites sites_;
    std::map<std::set<std::size_t>, std::vector<Loops>> diagrams_;
};

/// Joins pieces that touch, unless they would enclose a hole: to cut the hole open might cut a region.
Loops joined(Loops pieces) {
    if (pieces.size() < 2) return pieces;
    Loops whole = union_of(pieces, {});
    const bool has_hole =
        std::any_of(whole.begin(), whole.end(), [](const Loop& loop) { return twice_area(loop) < 0; });
    return has_hole ? std::move(pieces) : std::move(whole);
}

bool is_within(const Box& inner, const Box& outer) {
    return intersection(inner, outer) == inner;
}

/// Divides an area among some regions.
CanvasShares shared_among(std::span<const Polygon> regions, const std::vector<Loops>& cores,
                          const Box& canvas, const Loops& area, const VoronoiSites& sites) {
    const bool is_whole = area.size() == 1 && area[0] == to_grid(to_polygon(canvas));
    const std::vector<Loops> nearest = voronoi(regions, canvas, sites);
    CanvasShares shares{std::vector<Loops>(regions.size()), std::vector<Loops>(regions.size())};
    LeftoverSharing sharing(regions, canvas, sites);
    for (std::size_t i = 0; i < regions.size(); ++i) {
        const bool is_clipped =
            is_whole && (nearest[i].empty() || is_within(bounds_of_loops(nearest[i]), canvas));
        const Loops mine = is_clipped ? nearest[i] : intersection_of(nearest[i], area);
        if (mine.empty()) continue;
        if (!cores[i].empty() && is_within(bounds_of_loops(mine), bounds_of_loops(cores[i]))) {
            append(shares.shown[i], mine);
            continue;
        }
        append(shares.shown[i], intersection_of(mine, cores[i]));
        for (const Leftover& leftover : split_by_takers(difference_of(mine, cores[i]), cores)) {
            if (leftover.takers.empty())
                append(shares.filler[i], leftover.area);
            else
                sharing.give(leftover, shares.shown);
        }
    }
    for (std::vector<Loops>* some : {&shares.shown, &shares.filler})
        for (Loops& loops : *some)
            loops = joined(std::move(loops));
    return shares;
}

/// Gives places where no item of a group has pixels to other items that have some there.
void share_filler(CanvasShares& shares, const ItemAreas& sites, const Box& canvas, const VoronoiSites& how) {
    LeftoverSharing sharing(sites.regions, canvas, how);
    for (Loops& filler : shares.filler) {
        const Loops area = std::exchange(filler, {});
        for (const Leftover& leftover : split_by_takers(area, sites.cores)) {
            if (leftover.takers.empty())
                append(filler, leftover.area);
            else
                sharing.give(leftover, shares.shown);
        }
    }
    for (std::vector<Loops>* some : {&shares.shown, &shares.filler})
        for (Loops& loops : *some)
            loops = joined(std::move(loops));
}

/// Adds a group as one item: the hull of its regions, and the box around its cores.
void add_as_one(ItemAreas& units, const ItemAreas& sites, const LayoutGroup& group) {
    std::vector<Vec2> corners;
    std::optional<Box> frame;
    for (const std::size_t i : group.items) {
        corners.insert(corners.end(), sites.regions[i].begin(), sites.regions[i].end());
        if (sites.cores[i].empty()) continue;
        const Box core = bounds_of_loops(sites.cores[i]);
        frame = frame ? united(*frame, core) : core;
    }
    units.regions.push_back(convex_hull(corners));
    units.cores.emplace_back();
    if (frame) units.cores.back().push_back(to_grid(to_polygon(*frame)));
}

}  // namespace

double distance_to(const Polygon& region, Vec2 point) {
    if (is_inside_convex(region, point, 0)) return 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < region.size(); ++k) {
        const Vec2 a = region[k];
        const Vec2 along = region[(k + 1) % region.size()] - a;
        const double squared = dot(along, along);
        const double share = squared > 0 ? std::clamp(dot(point - a, along) / squared, 0.0, 1.0) : 0;
        smallest = std::min(smallest, length(point - a - along * share));
    }
    return smallest;
}

CanvasShares share_canvas(const ItemAreas& sites, const std::vector<LayoutGroup>& groups, const Box& canvas,
                          const VoronoiSites& how) {
    const Loops screen{to_grid(to_polygon(canvas))};
    if (groups.empty()) return shared_among(sites.regions, sites.cores, canvas, screen, how);
    std::vector<LayoutGroup> units = groups;
    std::vector<bool> is_grouped(sites.regions.size(), false);
    for (const LayoutGroup& group : groups)
        for (const std::size_t i : group.items)
            is_grouped[i] = true;
    for (std::size_t i = 0; i < sites.regions.size(); ++i)
        if (!is_grouped[i]) units.push_back({{i}});
    ItemAreas outer;
    for (const LayoutGroup& unit : units)
        add_as_one(outer, sites, unit);
    const CanvasShares shares = shared_among(outer.regions, outer.cores, canvas, screen, how);
    CanvasShares all{std::vector<Loops>(sites.regions.size()), std::vector<Loops>(sites.regions.size())};
    for (std::size_t u = 0; u < units.size(); ++u) {
        ItemAreas inner;
        for (const std::size_t i : units[u].items) {
            inner.regions.push_back(sites.regions[i]);
            inner.cores.push_back(sites.cores[i]);
        }
        const Loops area = union_of(shares.shown[u], shares.filler[u]);
        CanvasShares some = shared_among(inner.regions, inner.cores, canvas, area, how);
        for (std::size_t k = 0; k < units[u].items.size(); ++k) {
            all.shown[units[u].items[k]] = std::move(some.shown[k]);
            all.filler[units[u].items[k]] = std::move(some.filler[k]);
        }
    }
    share_filler(all, sites, canvas, how);
    return all;
}

}  // namespace vitrine::player
