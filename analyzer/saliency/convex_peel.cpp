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
constexpr double faint = 0.5;  // times the mean density inside: what a tight region may still lose
constexpr int thickest = 12;   // px of a slab; halved until one fits

struct Pixel {
    Vec2 centre;
    double mass = 0;
    bool is_inside = true;
};

/// One direction in which slabs are cut: pixels lie in bins one pixel wide by their projection on it.
struct Direction {
    Vec2 normal;
    double origin = 0;         // projection at which bin 0 starts
    std::vector<double> mass;  // of each bin
    std::vector<double> area;  // px
    std::vector<int> bin_of;   // by pixel
    int end = 0;               // bins [0, end) are still inside
    int least_end = 0;         // below which a face would be cut
};

struct Cut {
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

Direction direction(double angle, const std::vector<Pixel>& pixels, const Polygon& outline,
                    std::span<const Box> whole) {
    Direction d{.normal = {std::cos(angle), std::sin(angle)}, .mass = {}, .area = {}, .bin_of = {}};
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
        d.least_end = std::clamp(static_cast<int>(std::ceil(reach)), d.least_end, d.end);
    }
    return d;
}

/// Bins at the end without pixels cost nothing and hold nothing: they go first.
void drop_empty_bins(Direction& d) {
    while (d.end > std::max(1, d.least_end) && d.area[static_cast<std::size_t>(d.end - 1)] <= 0)
        --d.end;
}

/// The slab with the least mass per area that still may be cut; thickness 0 if there is none.
Cut cheapest(const std::vector<Direction>& all, double spare_mass, double most_area) {
    Cut best;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Direction& d = all[i];
        Cut cut{.direction = i};
        const int most = std::min(thickest, d.end - std::max(1, d.least_end));
        for (int t = 1; t <= most; ++t) {
            cut.mass += d.mass[static_cast<std::size_t>(d.end - t)];
            cut.area += d.area[static_cast<std::size_t>(d.end - t)];
            cut.thickness = t;
            if (cut.mass > spare_mass || cut.area > most_area) break;
            if (best.thickness == 0 || cut.density() < best.density()) best = cut;
        }
    }
    return best;
}

/// The region while it shrinks.
struct Peel {
    std::vector<Pixel> pixels;
    std::vector<Direction> all;
    double mass = 0;
    double area = 0;

    void apply(const Cut& cut) {
        Direction& d = all[cut.direction];
        d.end -= cut.thickness;
        for (std::size_t k = 0; k < pixels.size(); ++k) {
            if (!pixels[k].is_inside || d.bin_of[k] < d.end) continue;
            pixels[k].is_inside = false;
            for (Direction& other : all) {
                other.mass[static_cast<std::size_t>(other.bin_of[k])] -= pixels[k].mass;
                other.area[static_cast<std::size_t>(other.bin_of[k])] -= 1;
            }
        }
        mass -= cut.mass;
        area -= cut.area;
        for (Direction& other : all)
            drop_empty_bins(other);
    }
};

Peel start(const SaliencyMap& map, const Box& within, std::span<const Box> whole) {
    Peel peel{.pixels = pixels_of(map, within), .all = {}};
    if (peel.pixels.empty()) return peel;
    for (int k = 0; k < directions; ++k) {
        peel.all.push_back(
            direction(2 * std::numbers::pi * k / directions, peel.pixels, to_polygon(within), whole));
    }
    for (const Pixel& pixel : peel.pixels)
        peel.mass += pixel.mass;
    peel.area = static_cast<double>(peel.pixels.size());
    return peel;
}

/// Cuts until a further slab would leave less than `mass` or less than `area`, or is at least `dense` times
/// as dense as what is left.
void shrink(Peel& peel, double mass, double area, double dense = std::numeric_limits<double>::infinity()) {
    for (;;) {
        const Cut cut = cheapest(peel.all, peel.mass - mass, peel.area - std::max(1.0, area));
        if (cut.thickness == 0 || cut.mass * peel.area >= dense * peel.mass * cut.area) break;
        peel.apply(cut);
    }
}

Polygon outline(const Peel& peel, const Box& within) {
    std::vector<HalfPlane> planes;
    for (const Direction& d : peel.all)
        planes.push_back({d.normal, d.origin + d.end});
    return cut_by(to_polygon(within), planes);
}

}  // namespace

Polygon peeled(const SaliencyMap& map, const Box& within, const PeelLimits& limits) {
    Peel peel = start(map, within, limits.whole);
    if (peel.pixels.empty()) return {};
    const double mass = cv::sum(map)[0];
    const auto whole = static_cast<double>(map.total());
    shrink(peel, 0, limits.most_area * whole);
    shrink(peel, limits.safe_mass * mass, 0);
    Polygon safe = outline(peel, within);
    shrink(peel, limits.tight_mass * mass, limits.tight_area * whole);
    const double one_slab = std::hypot(map.cols, map.rows);
    if (peel.area > limits.tight_area * whole + one_slab) return safe;
    shrink(peel, limits.snug_mass * mass, 0, faint);
    return outline(peel, within);
}

}  // namespace vitrine::analyzer
