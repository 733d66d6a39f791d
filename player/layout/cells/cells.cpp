#include "player/layout/cells/cells.hpp"

#include "player/layout/cells/sharing.hpp"
#include "player/layout/cells/triangulation.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

/// Takes half a gutter from each cell along every border of two cells.
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

/// Rounds the corners of each cell without cutting its I-Region.
void round_corners(std::vector<Loops>& shown, std::span<const Polygon> regions, double radius) {
    if (radius <= 0) return;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const Loops inner = grown(shown[i], -radius);
        const Loops rounded = inner.empty() ? inner : intersection_of(grown(inner, radius), shown[i]);
        shown[i] = union_of(rounded, {to_grid(regions[i])});
    }
}

/// The edge along which a cell fades out over its neighbours: not over another I-Region, and no farther than
/// the cell has pixels.
FadeEdge fade_edge(const Polygon& outline, std::size_t item, std::span<const Polygon> regions,
                   const Box& core, double feather) {
    const double spacing = std::max(2.0, feather / 2);  // canvas px between corners
    FadeEdge edge;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 a = outline[k];
        const Vec2 along = outline[(k + 1) % outline.size()] - a;
        const int pieces = std::max(1, static_cast<int>(std::ceil(length(along) / spacing)));
        for (int i = 0; i < pieces; ++i) {
            const Vec2 p = a + along * (static_cast<double>(i) / pieces);
            double room = std::min({p.x - core.min.x, core.max.x - p.x, p.y - core.min.y, core.max.y - p.y});
            for (std::size_t j = 0; j < regions.size(); ++j)
                if (j != item) room = std::min(room, distance_to(regions[j], p) - spacing / 2);
            edge.outline.push_back(p);
            edge.widths.push_back(std::clamp(room, 1.0, feather));
        }
    }
    return edge;
}

/// Puts the part with the I-Region's centroid first.
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
    ItemAreas sites;
    std::vector<Box> frames;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Placement& at = layout.placements[i];
        sites.regions.push_back(placed_region(items[i], at));
        frames.push_back(
            {items[i].core.min * at.scale + at.offset, items[i].core.max * at.scale + at.offset});
        const Box core = intersection(frames.back(), canvas);
        sites.cores.emplace_back();
        if (!core.is_empty()) sites.cores.back().push_back(to_grid(to_polygon(core)));
    }
    CanvasShares shares = share_canvas(sites, layout.groups, canvas,
                                       {.spacing = style.sample_spacing, .inset = style.sample_inset});
    open_gutters(shares.shown, sites.regions, style.gutter);
    round_corners(shares.shown, sites.regions, style.corner_radius);
    std::vector<Loops*> all;
    for (std::vector<Loops>* some : {&shares.shown, &shares.filler})
        for (Loops& loops : *some) {
            loops = without_holes(loops);
            all.push_back(&loops);
        }
    share_corners(all);
    std::vector<Cell> result(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        Cell& cell = result[i];
        add_to(cell.parts, cell.triangles, shares.shown[i]);
        add_to(cell.filler, cell.filler_triangles, shares.filler[i]);
        put_first(cell.parts, sites.regions[i]);
        if (style.gutter > 0 || style.corner_radius > 0) cell.edge_coverage = 1;
        for (std::size_t k = 0; style.feather > 1 && k < cell.parts.size(); ++k)
            cell.fade_edges.push_back(fade_edge(cell.parts[k], i, sites.regions, frames[i], style.feather));
    }
    return result;
}

}  // namespace vitrine::player
