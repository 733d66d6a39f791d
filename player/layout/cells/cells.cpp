#include "player/layout/cells/cells.hpp"

#include "player/layout/cells/far_parts.hpp"
#include "player/layout/cells/seam_bends.hpp"
#include "player/layout/cells/sharing.hpp"
#include "player/layout/cells/taut.hpp"
#include "player/layout/cells/triangulation.hpp"

#include "base/geometry/convex_hull.hpp"

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

/// True if the corners of cells are cut off. Taut seams without a gutter have round bends, which take nothing
/// from the cells.
bool cuts_corners(const CellStyle& style) {
    return style.corner_radius > 0 && (style.gutter > 0 || !style.is_taut);
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

/// The smallest distances of each region to another one, canvas px, up to a limit.
std::vector<double> rooms_between(std::span<const Polygon> regions, double limit) {
    std::vector<double> rooms(regions.size(), limit);
    for (std::size_t i = 0; i < regions.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (regions[i].empty() || regions[j].empty()) continue;
            const Box a = bounding_box(regions[i]);
            const Box b = bounding_box(regions[j]);
            if (a.min.x - b.max.x > limit || b.min.x - a.max.x > limit || a.min.y - b.max.y > limit ||
                b.min.y - a.max.y > limit)
                continue;
            double room = limit;
            for (const Vec2& p : regions[i])
                room = std::min(room, distance_to(regions[j], p));
            for (const Vec2& p : regions[j])
                room = std::min(room, distance_to(regions[i], p));
            rooms[i] = std::min(rooms[i], room);
            rooms[j] = std::min(rooms[j], room);
        }
    return rooms;
}

/// A convex region with up to `margin` px around its edges and up to `reach` px around its corners.
Polygon widened(const Polygon& region, double margin, double reach) {
    if (region.size() < 3 || reach <= 0) return region;
    Polygon corners = region;
    for (std::size_t k = 0; k < region.size(); ++k) {
        const Vec2 in = region[k] - region[(k + region.size() - 1) % region.size()];
        const Vec2 out = region[(k + 1) % region.size()] - region[k];
        const Vec2 normals = Vec2{in.y, -in.x} * (1 / length(in)) + Vec2{out.y, -out.x} * (1 / length(out));
        const double squared = dot(normals, normals);
        if (!(squared > 0.1)) continue;  // a needle
        const Vec2 by = normals * (2 * margin / squared);
        corners.push_back(region[k] + by * std::min(1.0, reach / length(by)));
    }
    return convex_hull(corners);
}

struct SeamForm {
    double margin = 0;  // canvas px that seams keep from regions where there is room
    double radius = 0;  // canvas px
};

/// Pulls the seams between the cells taut, and rounds their bends.
void straighten(CanvasShares& shares, const ItemAreas& items, const Box& canvas, const SeamForm& form) {
    constexpr double flattening = 0.5;  // canvas px: twice the error of flattened arcs
    const std::size_t count = items.regions.size();
    std::vector<Loops> areas = shares.shown;
    areas.insert(areas.end(), shares.filler.begin(), shares.filler.end());
    auto seams = seams_of(std::move(areas), canvas);
    if (!seams) return;
    const std::vector<double> rooms = rooms_between(items.regions, 2 * (form.margin + flattening) + 1);
    SeamLimits limits{.cores = items.cores};
    for (std::size_t i = 0; i < count; ++i) {
        limits.regions.push_back(to_grid(items.regions[i]));
        const Box bounds = items.cores[i].empty() ? Box{} : bounding_box(from_grid(items.cores[i][0]));
        const double reach = (rooms[i] - flattening) / 2;
        limits.reserves.push_back(to_grid(clipped(widened(items.regions[i], form.margin, reach), bounds)));
    }
    pull_taut(*seams, limits);
    if (form.radius > 0) round_bends(*seams, limits, form.radius);
    areas = areas_of(*seams, 2 * count);
    for (std::size_t i = 0; i < count; ++i) {
        shares.shown[i] = std::move(areas[i]);
        shares.filler[i] = std::move(areas[count + i]);
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

/// A core within the canvas. Sides that are less than a pixel from the canvas' edges are moved onto them,
/// where the picture's outermost pixels are repeated. The strips between would go to other items, as needles
/// along the edge.
Box reaching_edges(Box core, const Box& canvas) {
    constexpr double near = 1;  // canvas px
    if (core.is_empty()) return core;
    if (core.min.x - canvas.min.x < near) core.min.x = canvas.min.x;
    if (core.min.y - canvas.min.y < near) core.min.y = canvas.min.y;
    if (canvas.max.x - core.max.x < near) core.max.x = canvas.max.x;
    if (canvas.max.y - core.max.y < near) core.max.y = canvas.max.y;
    return core;
}

void add_to(std::vector<Polygon>& polygons, std::vector<std::array<Vec2, 3>>& triangles, const Loops& loops) {
    for (const Loop& loop : loops) {
        polygons.push_back(from_grid(loop));
        for (const GridTriangle& t : triangulated(loop))
            triangles.push_back({from_grid(t[0]), from_grid(t[1]), from_grid(t[2])});
    }
}

}  // namespace

LayoutItem without_bleeding_edge(LayoutItem item, Vec2 picture, const Placement& at) {
    constexpr double bleeding = 3;  // canvas px
    const double depth = bleeding / at.scale;
    const Box region = bounding_box(item.region);
    const auto keep_low = [&](double& side, double limit) {
        if (side > 0) side = std::max(side, std::min(side + depth, limit));
    };
    const auto keep_high = [&](double& side, double limit, double end) {
        if (side < end) side = std::min(side, std::max(side - depth, limit));
    };
    keep_low(item.core.min.x, region.min.x);
    keep_low(item.core.min.y, region.min.y);
    keep_high(item.core.max.x, region.max.x, picture.x);
    keep_high(item.core.max.y, region.max.y, picture.y);
    return item;
}

std::vector<Cell> cells(std::span<const LayoutItem> items, const Layout& layout, const CellStyle& style) {
    const Box canvas{{0, 0}, layout.canvas};
    ItemAreas sites;
    std::vector<Box> frames;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Placement& at = layout.placements[i];
        sites.regions.push_back(placed_region(items[i], at));
        frames.push_back(placed_core(items[i], at));
        const Box core = reaching_edges(intersection(frames.back(), canvas), canvas);
        sites.cores.emplace_back();
        if (!core.is_empty()) sites.cores.back().push_back(to_grid(to_polygon(core)));
    }
    CanvasShares shares = share_canvas(sites, layout.groups, canvas,
                                       {.spacing = style.sample_spacing, .inset = style.sample_inset});
    give_far_parts(shares.shown, sites);
    // The hulls of two groups may be nearer to each other than any two regions are.
    const double margin = layout.groups.empty() ? style.gutter / 2 + 1 : 0;
    if (style.is_taut) straighten(shares, sites, canvas, {.margin = margin, .radius = style.corner_radius});
    open_gutters(shares.shown, sites.regions, style.gutter);
    if (cuts_corners(style)) round_corners(shares.shown, sites.regions, style.corner_radius);
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
        if (style.gutter > 0 || cuts_corners(style)) cell.edge_coverage = 1;
        for (std::size_t k = 0; style.feather > 1 && k < cell.parts.size(); ++k)
            cell.fade_edges.push_back(fade_edge(cell.parts[k], i, sites.regions, frames[i], style.feather));
    }
    return result;
}

}  // namespace vitrine::player
