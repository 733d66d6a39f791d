#include "analyzer/saliency/convex_peel.hpp"

#include "analyzer/saliency/half_planes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace vitrine::analyzer {
namespace {

constexpr int directions = 24;
constexpr double faint = 0.5;  // times the mean density inside: a tight region may still lose slabs below it
constexpr int max_thickness = 12;  // px of a slab; halved until one fits

struct Pixel {
    Vec2 centre;
    double mass = 0;
    bool is_inside = true;
};

/// One direction in which slabs are cut: pixels lie in bins one pixel wide by their projection on it.
struct CutDirection {
    Vec2 normal;
    double origin = 0;         // projection at which bin 0 starts
    std::vector<double> mass;  // one a bin
    std::vector<double> area;  // one a bin, px
    std::vector<int> bin_of;   // one a pixel
    int end = 0;               // bins [0, end) are still inside
    int min_end = 0;           // a smaller end would cut a face
};

/// A slab at the end of a direction.
struct Slab {
    std::size_t direction = 0;
    int thickness = 0;
    double mass = 0;
    double area = 0;

    double density() const { return mass / area; }
};

std::vector<Pixel> pixels_of(const SaliencyMap& map, const Box& within) {
    std::vector<Pixel> pixels;
    for (int y = 0; y < map.rows; ++y) {
        for (int x = 0; x < map.cols; ++x) {
            const Vec2 centre{x + 0.5, y + 0.5};
            if (centre.x < within.min.x || centre.x > within.max.x) continue;
            if (centre.y < within.min.y || centre.y > within.max.y) continue;
            pixels.push_back({.centre = centre, .mass = static_cast<double>(map.at<float>(y, x))});
        }
    }
    return pixels;
}

double furthest(std::span<const Vec2> points, Vec2 normal) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec2 p : points)
        most = std::max(most, dot(p, normal));
    return most;
}

CutDirection direction(double angle, const std::vector<Pixel>& pixels, const Polygon& outline,
                       std::span<const Box> whole) {
    CutDirection d{.normal = {std::cos(angle), std::sin(angle)}, .mass = {}, .area = {}, .bin_of = {}};
    d.origin = -furthest(outline, d.normal * -1);
    d.end = std::max(1, static_cast<int>(std::ceil(furthest(outline, d.normal) - d.origin)));
    d.mass.resize(static_cast<std::size_t>(d.end));
    d.area.resize(static_cast<std::size_t>(d.end));
    for (const Pixel& pixel : pixels) {
        const int bin = std::clamp(static_cast<int>(dot(pixel.centre, d.normal) - d.origin), 0, d.end - 1);
        d.bin_of.push_back(bin);
        d.mass[static_cast<std::size_t>(bin)] += pixel.mass;
        d.area[static_cast<std::size_t>(bin)] += 1;
    }
    for (const Box& box : whole) {
        const double reach = furthest(to_polygon(box), d.normal) - d.origin;
        d.min_end = std::clamp(static_cast<int>(std::ceil(reach)), d.min_end, d.end);
    }
    return d;
}

/// Drops the bins at the end that have no pixels: they cost nothing.
void drop_empty_bins(CutDirection& d) {
    while (d.end > std::max(1, d.min_end) && d.area[static_cast<std::size_t>(d.end - 1)] <= 0)
        --d.end;
}

/// The slab with the least mass per area that still may be cut; thickness 0 if there is none.
Slab cheapest(const std::vector<CutDirection>& all, double spare_mass, double max_area) {
    Slab best;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const CutDirection& d = all[i];
        Slab cut{.direction = i};
        const int end = std::min(max_thickness, d.end - std::max(1, d.min_end));
        for (int t = 1; t <= end; ++t) {
            cut.mass += d.mass[static_cast<std::size_t>(d.end - t)];
            cut.area += d.area[static_cast<std::size_t>(d.end - t)];
            cut.thickness = t;
            if (cut.mass > spare_mass || cut.area > max_area) break;
            if (best.thickness == 0 || cut.density() < best.density()) best = cut;
        }
    }
    return best;
}

/// The region while it shrinks.
struct ShrinkingRegion {
    std::vector<Pixel> pixels;
    std::vector<CutDirection> all;
    double mass = 0;
    double area = 0;

    void apply(const Slab& cut) {
        CutDirection& d = all[cut.direction];
        d.end -= cut.thickness;
        for (std::size_t k = 0; k < pixels.size(); ++k) {
            if (!pixels[k].is_inside || d.bin_of[k] < d.end) continue;
            pixels[k].is_inside = false;
            for (CutDirection& other : all) {
                other.mass[static_cast<std::size_t>(other.bin_of[k])] -= pixels[k].mass;
                other.area[static_cast<std::size_t>(other.bin_of[k])] -= 1;
            }
        }
        mass -= cut.mass;
        area -= cut.area;
        for (CutDirection& other : all)
            drop_empty_bins(other);
    }
};

ShrinkingRegion start(const SaliencyMap& map, const Box& within, std::span<const Box> whole) {
    ShrinkingRegion region{.pixels = pixels_of(map, within), .all = {}};
    if (region.pixels.empty()) return region;
    for (int k = 0; k < directions; ++k) {
        region.all.push_back(
            direction(2 * std::numbers::pi * k / directions, region.pixels, to_polygon(within), whole));
    }
    for (const Pixel& pixel : region.pixels)
        region.mass += pixel.mass;
    region.area = static_cast<double>(region.pixels.size());
    return region;
}

/// Cuts until a further slab would leave less than `mass` or less than `area`, or is at least `dense` times
/// as dense as the rest.
void shrink(ShrinkingRegion& region, double mass, double area,
            double dense = std::numeric_limits<double>::infinity()) {
    for (;;) {
        const Slab cut = cheapest(region.all, region.mass - mass, region.area - std::max(1.0, area));
        if (cut.thickness == 0 || cut.mass * region.area >= dense * region.mass * cut.area) break;
        region.apply(cut);
    }
}

Polygon outline(const ShrinkingRegion& region, const Box& within) {
    std::vector<HalfPlane> planes;
    for (const CutDirection& d : region.all)
        planes.push_back({d.normal, d.origin + d.end});
    return cut_by(to_polygon(within), planes);
}

}  // namespace

Polygon peeled(const SaliencyMap& map, const Box& within, const PeelLimits& limits) {
    ShrinkingRegion region = start(map, within, limits.whole);
    if (region.pixels.empty()) return {};
    const double mass = cv::sum(map)[0];
    const auto whole = static_cast<double>(map.total());
    shrink(region, 0, limits.max_area * whole);
    shrink(region, limits.safe_mass * mass, 0);
    Polygon safe = outline(region, within);
    shrink(region, limits.tight_mass * mass, limits.tight_area * whole);
    const double one_slab = std::hypot(map.cols, map.rows);
    if (region.area > limits.tight_area * whole + one_slab) return safe;
    shrink(region, limits.snug_mass * mass, 0, faint);
    return outline(region, within);
}

}  // namespace vitrine::analyzer
