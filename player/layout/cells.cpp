#include "player/layout/cells.hpp"

#include "player/layout/grid.hpp"
#include "player/layout/triangulation.hpp"
#include "player/layout/voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace vitrine {

namespace {

/// Part of the canvas whose nearest item has no pixels there, with those that have.
struct Orphan {
    Loops area;
    std::set<std::size_t> takers;
};

struct Shares {
    std::vector<Loops> shown;   // per item, from its own pixels
    std::vector<Loops> filler;  // per item, where nobody has pixels
};

void append(Loops& to, const Loops& more) {
    to.insert(to.end(), more.begin(), more.end());
}

Box bounds_of(const Loops& loops) {
    std::vector<Vec2> corners;
    for (const Loop& loop : loops)
        for (const CellPoint& p : loop)
            corners.push_back(from_grid(p));
    return bounding_box(corners);
}

/// Splits what has no owner by who has pixels there.
std::vector<Orphan> split_by_takers(const Loops& orphaned, const std::vector<Loops>& cores) {
    std::vector<Orphan> orphans;
    if (!orphaned.empty()) orphans.push_back({orphaned, {}});
    for (std::size_t i = 0; i < cores.size(); ++i) {
        if (cores[i].empty()) continue;
        const Box core = bounds_of(cores[i]);
        std::vector<Orphan> next;
        for (Orphan& orphan : orphans) {
            const Box bounds = bounds_of(orphan.area);
            if (intersection(bounds, core).is_empty()) {
                next.push_back(std::move(orphan));
                continue;
            }
            if (intersection(bounds, core) == bounds) {
                orphan.takers.insert(i);
                next.push_back(std::move(orphan));
                continue;
            }
            Loops inside = intersection_of(orphan.area, cores[i]);
            Loops outside = difference_of(orphan.area, cores[i]);
            if (!outside.empty()) next.push_back({std::move(outside), orphan.takers});
            orphan.takers.insert(i);
            if (!inside.empty()) next.push_back({std::move(inside), std::move(orphan.takers)});
        }
        orphans = std::move(next);
    }
    return orphans;
}

double distance(const Box& a, const Box& b) {
    return length({std::max({0.0, a.min.x - b.max.x, b.min.x - a.max.x}),
                   std::max({0.0, a.min.y - b.max.y, b.min.y - a.max.y})});
}

/// The most that any point of a box can be away from a region, or more.
double most_distance(const Box& box, const Polygon& region) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& p : region)
        least = std::min(least, length({std::max(p.x - box.min.x, box.max.x - p.x),
                                        std::max(p.y - box.min.y, box.max.y - p.y)}));
    return least;
}

/// Those of some takers that can be the nearest somewhere in an area.
std::set<std::size_t> likely_takers(const Orphan& orphan, std::span<const Polygon> regions) {
    const Box bounds = bounds_of(orphan.area);
    double reach = std::numeric_limits<double>::infinity();
    for (const std::size_t taker : orphan.takers)
        reach = std::min(reach, most_distance(bounds, regions[taker]));
    std::set<std::size_t> likely;
    for (const std::size_t taker : orphan.takers)
        if (distance(bounds, bounding_box(regions[taker])) <= reach) likely.insert(taker);
    return likely;
}

/// Gives each orphan to its nearest takers.
class Adoption {
  public:
    Adoption(std::span<const Polygon> regions, const Box& canvas, const VoronoiSites& sites)
        : regions_(regions), canvas_(canvas), sites_(sites) {}

    void give(const Orphan& orphan, std::vector<Loops>& shown) {
        const std::set<std::size_t> takers = likely_takers(orphan, regions_);
        if (takers.size() == 1) {
            append(shown[*takers.begin()], orphan.area);
            return;
        }
        const std::vector<Loops>& diagram = diagram_of(takers);
        Loops rest = orphan.area;
        for (const std::size_t taker : takers) {
            append(shown[taker], intersection_of(orphan.area, diagram[taker]));
            rest = difference_of(rest, diagram[taker]);
        }
        append(shown[*orphan.takers.begin()], rest);  // what rounding left
    }

  private:
    /// The diagram of some regions only, indexed as all.
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

/// Pieces that meet become one, unless they would enclose a hole: cutting that open again might cut a region.
Loops joined(Loops pieces) {
    if (pieces.size() < 2) return pieces;
    Loops whole = union_of(pieces, {});
    const bool has_hole =
        std::any_of(whole.begin(), whole.end(), [](const Loop& loop) { return twice_area(loop) < 0; });
    return has_hole ? std::move(pieces) : std::move(whole);
}

Shares shared_out(std::span<const Polygon> regions, const std::vector<Loops>& cores, const Box& canvas,
                  const VoronoiSites& sites) {
    const Loops screen{to_grid(to_polygon(canvas))};
    const std::vector<Loops> nearest = voronoi(regions, canvas, sites);
    Shares shares;
    Loops orphaned;
    std::vector<Loops> lost(regions.size());
    for (std::size_t i = 0; i < regions.size(); ++i) {
        const Loops on_screen = intersection_of(nearest[i], screen);
        shares.shown.push_back(intersection_of(on_screen, cores[i]));
        lost[i] = difference_of(on_screen, cores[i]);
        append(orphaned, lost[i]);
    }
    orphaned = union_of(orphaned, {});
    shares.filler.resize(regions.size());
    Adoption adoption(regions, canvas, sites);
    for (const Orphan& orphan : split_by_takers(orphaned, cores)) {
        if (!orphan.takers.empty()) {
            adoption.give(orphan, shares.shown);
            continue;
        }
        for (std::size_t i = 0; i < regions.size(); ++i)
            append(shares.filler[i], intersection_of(orphan.area, lost[i]));
    }
    for (std::vector<Loops>* some : {&shares.shown, &shares.filler})
        for (Loops& loops : *some)
            loops = joined(std::move(loops));
    return shares;
}

/// Takes the half of a gap along every border between two cells.
void open_gutters(std::vector<Loops>& shown, std::span<const Polygon> regions, double gutter) {
    if (gutter <= 0) return;
    std::vector<Loops> wide;
    wide.reserve(shown.size());
    for (const Loops& loops : shown)
        wide.push_back(grown(loops, gutter / 2));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        for (std::size_t j = 0; j < shown.size(); ++j)
            if (j != i) shown[i] = difference_of(shown[i], wide[j]);
        shown[i] = union_of(shown[i], {to_grid(regions[i])});  // a wide gutter ends at the I-Region
    }
}

/// The loop that holds a point of the I-Region comes first.
void put_first(std::vector<Polygon>& parts, const Polygon& region) {
    if (region.empty()) return;
    const Vec2 p = centroid(region);
    const auto holds = [&](const Polygon& part) {
        bool inside = false;
        for (std::size_t k = 0, before = part.size() - 1; k < part.size(); before = k++) {
            const Vec2 a = part[k];
            const Vec2 b = part[before];
            if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
                inside = !inside;
        }
        return inside;
    };
    const auto found = std::find_if(parts.begin(), parts.end(), holds);
    if (found != parts.end()) std::iter_swap(parts.begin(), found);
}

void add_to(std::vector<Polygon>& polygons, std::vector<std::array<Vec2, 3>>& triangles, const Loops& loops) {
    for (const Loop& loop : loops) {
        polygons.push_back(from_grid(loop));
        for (const GridTriangle& t : triangulated(loop))
            triangles.push_back({from_grid(t[0]), from_grid(t[1]), from_grid(t[2])});
    }
}

}  // namespace

std::vector<Cell> cells(std::span<const LayoutItem> items, const Layout& layout, const CellStyle& style) {
    const Box canvas{{0, 0}, layout.canvas};
    std::vector<Polygon> regions;
    std::vector<Loops> cores;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Placement& at = layout.placements[i];
        regions.push_back(placed_region(items[i], at));
        const Box core{items[i].core.min * at.scale + at.offset, items[i].core.max * at.scale + at.offset};
        cores.push_back({to_grid(to_polygon(intersection(core, canvas)))});
        if (intersection(core, canvas).is_empty()) cores.back().clear();
    }
    const VoronoiSites sites{.spacing = style.sample_spacing, .inset = style.sample_inset};
    Shares shares = shared_out(regions, cores, canvas, sites);
    open_gutters(shares.shown, regions, style.gutter);
    std::vector<Loops*> all;
    for (std::vector<Loops>* some : {&shares.shown, &shares.filler})
        for (Loops& loops : *some) {
            loops = without_holes(loops);
            all.push_back(&loops);
        }
    share_corners(all);
    std::vector<Cell> result(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        add_to(result[i].parts, result[i].triangles, shares.shown[i]);
        add_to(result[i].filler, result[i].filler_triangles, shares.filler[i]);
        put_first(result[i].parts, regions[i]);
    }
    return result;
}

}  // namespace vitrine
