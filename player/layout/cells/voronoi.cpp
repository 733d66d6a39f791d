#include "player/layout/cells/voronoi.hpp"

#include "player/layout/cells/voronoi_check.hpp"
#include "player/layout/cells/voronoi_circles.hpp"
#include "player/layout/pack/overlap.hpp"

#include <boost/polygon/point_concept.hpp>
#include <boost/polygon/point_data.hpp>
#include <boost/polygon/segment_concept.hpp>
#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace vitrine::player {

namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using Edge = Diagram::edge_type;
using GridSegment = boost::polygon::segment_data<std::int32_t>;
using SitePoint = boost::polygon::point_data<std::int32_t>;

constexpr double bend_tolerance = 0.25;     // canvas px between a curve and its chords
constexpr double max_coordinate = 1 << 18;  // px, farther than any guard
constexpr int quarters = 4;
constexpr int tries = 4;                // of one diagram
constexpr double nearest_sites = 0.02;  // px between an I-Region and the site for it, after two tries
constexpr double coarse_spacing = 2;    // px between sampled points where no exact diagram is found
constexpr double beyond = 4;            // canvas sizes from the canvas to the guards, which bound all cells
constexpr std::int32_t site_origin = 1 << 25;  // grid units added to sites, see CheckedCircles

/// The input of the diagram, in units of grid_per_px. Its origin is `site_origin` up and left of the canvas.
struct Sites {
    std::vector<GridSegment> segments;
    std::vector<SitePoint> points;
    std::vector<std::size_t> owner_of_point;
    std::vector<std::size_t> owner_of_segment;

    /// Boost numbers first the points, then the segments.
    std::size_t owner(const Edge& edge) const {
        const std::size_t source = edge.cell()->source_index();
        return source < points.size() ? owner_of_point[source] : owner_of_segment[source - points.size()];
    }
};

SitePoint to_site(GridPoint p) {
    return {p.x + site_origin, p.y + site_origin};
}

SitePoint to_site(Vec2 p) {
    return {static_cast<std::int32_t>(std::lround(p.x * grid_per_px)) + site_origin,
            static_cast<std::int32_t>(std::lround(p.y * grid_per_px)) + site_origin};
}

Vec2 to_px(double x, double y) {
    return {(x - site_origin) / grid_per_px, (y - site_origin) / grid_per_px};
}

void add_outline(Sites& sites, const Polygon& region, std::size_t owner) {
    const GridPolygon outline = snapped(region);
    if (outline.empty()) {
        sites.points.push_back(to_site(region.empty() ? Vec2{} : region[0]));
        sites.owner_of_point.push_back(owner);
    }
    for (std::size_t k = 0; k < outline.size(); ++k) {
        sites.segments.emplace_back(to_site(outline[k]), to_site(outline[(k + 1) % outline.size()]));
        sites.owner_of_segment.push_back(owner);
    }
}

void add_samples(Sites& sites, const Polygon& region, std::size_t owner, const VoronoiSites& how) {
    const Vec2 middle = centroid(region);
    for (std::size_t k = 0; k < region.size(); ++k) {
        const Vec2 a = region[k];
        const Vec2 edge = region[(k + 1) % region.size()] - a;
        const int count = std::max(1, static_cast<int>(std::ceil(length(edge) / how.spacing)));
        for (int i = 0; i < count; ++i) {
            const Vec2 on = a + edge * (static_cast<double>(i) / count);
            const double depth = length(on - middle);
            const Vec2 p = on + (middle - on) * (depth > 0 ? std::min(1.0, how.inset / depth) : 0);
            sites.points.push_back(to_site(p));
            sites.owner_of_point.push_back(owner);
        }
    }
}

/// Adds four points far outside, so that every cell that reaches the canvas is bounded.
void add_guards(Sites& sites, const Box& canvas, std::size_t owner) {
    const double away = beyond * std::max(canvas.width(), canvas.height());
    const Vec2 c = canvas.centre();
    for (const Vec2 to : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
        sites.points.push_back(to_site(c + to * away));
        sites.owner_of_point.push_back(owner);
    }
}

/// The corners of the parabola between a point site and a line, without its ends: y = x^2 / 2p + p / 2 over
/// the line.
Polygon bend(Vec2 focus, Vec2 a, Vec2 b, Vec2 from, Vec2 to) {
    const Vec2 along = (b - a) * (1 / length(b - a));
    const double p = std::abs(cross(along, focus - a));
    const double side = cross(along, focus - a) > 0 ? 1 : -1;
    const Vec2 foot = a + along * dot(focus - a, along);
    const Vec2 up = Vec2{-along.y, along.x} * side;
    const double begin = dot(from - foot, along);
    const double end = dot(to - foot, along);
    // The chord over a width w is at most w^2 / 8p away from the parabola.
    constexpr double max_pieces = 1000;
    const double max_width = std::sqrt(8 * p * bend_tolerance);
    const double wished = std::abs(end - begin) / max_width;
    const int pieces = wished > 0 ? static_cast<int>(std::ceil(std::min(wished, max_pieces))) : 1;
    Polygon corners;
    for (int i = 1; i < pieces; ++i) {
        const double x = begin + (end - begin) * i / pieces;
        corners.push_back(foot + along * x + up * (x * x / (2 * p) + p / 2));
    }
    return corners;
}

/// Traces the outlines of the diagram's cells. The cells of one owner are traced as one.
class OutlineTracer {
  public:
    OutlineTracer(const Sites& sites, const Diagram& diagram, std::size_t owners)
        : sites_(sites), diagram_(diagram), loops_(owners) {}

    /// None: the diagram is damaged.
    std::optional<std::vector<Loops>> run() {
        for (const Edge& edge : diagram_.edges())
            if (is_border(edge) && sites_.owner(edge) < loops_.size() && edge.color() == untraced)
                if (!trace(edge)) return std::nullopt;
        return std::move(loops_);
    }

  private:
    static constexpr std::size_t untraced = 0;
    static constexpr std::size_t traced = 1;

    bool is_border(const Edge& edge) const { return sites_.owner(edge) != sites_.owner(*edge.twin()); }

    /// The next border edge of the same owner. The owner's area is on its left.
    const Edge& after(const Edge& edge) const {
        const Edge* next = edge.next();
        while (!is_border(*next))
            next = next->twin()->next();
        return *next;
    }

    bool trace(const Edge& first) {
        Loop loop;
        const Edge* edge = &first;
        do {
            if (edge->color() == traced) return false;
            edge->color(traced);
            if (!append(loop, *edge)) return false;
            edge = &after(*edge);
        } while (edge != &first);
        while (loop.size() > 1 && loop.front() == loop.back())
            loop.pop_back();
        if (loop.size() >= 3) loops_[sites_.owner(first)].push_back(std::move(loop));
        return true;
    }

    /// Appends the edge without its end. An edge has the same corners in both directions.
    /// @return false: it has no end, which no cell on the canvas has
    bool append(Loop& loop, const Edge& edge) {
        const bool forward = &edge < edge.twin();
        const Edge& base = forward ? edge : *edge.twin();
        if (base.vertex0() == nullptr || base.vertex1() == nullptr) return false;
        Polygon line = corners(base);
        if (!forward) std::reverse(line.begin(), line.end());
        line.pop_back();
        for (const Vec2& p : line) {
            if (!(std::abs(p.x) < max_coordinate && std::abs(p.y) < max_coordinate)) return false;
            const CellPoint point = to_grid(p);
            if (loop.empty() || loop.back() != point) loop.push_back(point);
        }
        return true;
    }

    Polygon corners(const Edge& edge) const {
        const Vec2 from = to_px(edge.vertex0()->x(), edge.vertex0()->y());
        const Vec2 to = to_px(edge.vertex1()->x(), edge.vertex1()->y());
        Polygon line{from};
        if (edge.is_curved()) {
            const bool point_here = edge.cell()->contains_point();
            const auto& point_cell = point_here ? *edge.cell() : *edge.twin()->cell();
            const auto& line_cell = point_here ? *edge.twin()->cell() : *edge.cell();
            const GridSegment& segment = sites_.segments[line_cell.source_index() - sites_.points.size()];
            const SitePoint focus = point_of(point_cell);
            const Polygon inner =
                bend(to_px(focus.x(), focus.y()), to_px(segment.low().x(), segment.low().y()),
                     to_px(segment.high().x(), segment.high().y()), from, to);
            line.insert(line.end(), inner.begin(), inner.end());
        }
        line.push_back(to);
        return line;
    }

    SitePoint point_of(const Diagram::cell_type& cell) const {
        const std::size_t source = cell.source_index();
        if (source < sites_.points.size()) return sites_.points[source];
        const GridSegment& segment = sites_.segments[source - sites_.points.size()];
        const bool start = cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
        return start ? segment.low() : segment.high();
    }

    const Sites& sites_;      // outlives this
    const Diagram& diagram_;  // outlives this
    std::vector<Loops> loops_;
};

/// None: the diagram is damaged.
std::optional<std::vector<Loops>> diagram_of(std::span<const Polygon> regions, const Box& canvas,
                                             const VoronoiSites& sites) {
    Sites input;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (sites.spacing > 0)
            add_samples(input, regions[i], i, sites);
        else
            add_outline(input, regions[i], i);
    }
    add_guards(input, canvas, regions.size());
    Diagram diagram;
    boost::polygon::voronoi_builder<std::int32_t, VoronoiNumbers, VoronoiPredicates> builder;
    boost::polygon::insert(input.points.begin(), input.points.end(), &builder);
    boost::polygon::insert(input.segments.begin(), input.segments.end(), &builder);
    builder.construct(&diagram);
    return OutlineTracer(input, diagram, regions.size()).run();
}

/// A point that was turned about the origin by some right angles.
template <typename Point> Point turned(Point point, int quarters_left) {
    for (int k = 0; k < quarters_left; ++k)
        point = {-point.y, point.x};
    return point;
}

Polygon turned(Polygon polygon, int quarters_left) {
    for (Vec2& corner : polygon)
        corner = turned(corner, quarters_left);
    return polygon;
}

/// A region that is smaller by a few steps of the grid on each side.
Polygon shrunk(Polygon region) {
    const Box box = bounding_box(region);
    const double factor = std::max(0.5, 1 - 2 * nearest_sites / std::min(box.width(), box.height()));
    const Vec2 middle = centroid(region);
    for (Vec2& corner : region)
        corner = middle + (corner - middle) * factor;
    return region;
}

/// The diagram of sites that are turned by some right angles, turned back.
std::optional<std::vector<Loops>> turned_diagram(std::span<const Polygon> regions, const Box& canvas,
                                                 int quarters_left) {
    std::vector<Polygon> sites;
    sites.reserve(regions.size());
    for (const Polygon& region : regions)
        sites.push_back(turned(region, quarters_left));
    auto found = diagram_of(sites, bounding_box(turned(to_polygon(canvas), quarters_left)), {});
    if (!found) return std::nullopt;
    for (Loops& loops : *found)
        for (Loop& loop : loops)
            for (CellPoint& point : loop)
                point = turned(point, quarters - quarters_left);
    return found;
}

}  // namespace

// Boost's diagram is wrong where sites meet on its grid, and for a few other sets of sites, which depends on
// the order in which its sweep meets them: whole cells lie elsewhere, vertices are missing or no numbers. So
// each diagram is checked. If it is wrong, it is made of turned sites, then of smaller ones.
std::vector<Loops> voronoi(std::span<const Polygon> regions, const Box& canvas, const VoronoiSites& sites) {
    const std::vector<Loops> none(regions.size());
    if (sites.spacing > 0) return diagram_of(regions, canvas, sites).value_or(none);
    std::vector<Polygon> tried(regions.begin(), regions.end());
    for (int k = 0; k < tries; ++k) {
        if (auto found = turned_diagram(tried, canvas, k % quarters);
            found && are_nearest(*found, regions, canvas))
            return std::move(*found);
        if (k == 0) continue;
        for (Polygon& region : tried)
            region = shrunk(region);
    }
    return diagram_of(regions, canvas, {.spacing = coarse_spacing}).value_or(none);
}

}  // namespace vitrine::player
