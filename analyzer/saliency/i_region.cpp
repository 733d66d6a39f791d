#include "analyzer/saliency/i_region.hpp"

#include "analyzer/saliency/convex_peel.hpp"
#include "analyzer/saliency/half_planes.hpp"
#include "base/geometry/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vitrine::analyzer {
namespace {

constexpr std::size_t max_corners = 12;
constexpr double min_area = 0.08;  // share of the picture
constexpr double max_area = 0.80;
// These two concern the region of a subject that a network has outlined.
constexpr double subject_min_area = 0.05;
constexpr double subject_margin = 0.01;  // share of the diagonal
constexpr double middle = 0.6;           // share of each side, where nothing is salient

Polygon middle_of(const Box& core) {
    const Vec2 half{core.width() * middle / 2, core.height() * middle / 2};
    return to_polygon({core.centre() - half, core.centre() + half});
}

/// The corners of all pixels from the most salient on that together hold the mass.
std::vector<Vec2> top_pixels(const SaliencyMap& volume, double mass) {
    std::vector<std::pair<float, int>> pixels;
    pixels.reserve(volume.total());
    for (int i = 0; i < static_cast<int>(volume.total()); ++i) {
        pixels.emplace_back(volume.at<float>(i / volume.cols, i % volume.cols), i);
    }
    std::sort(pixels.begin(), pixels.end(), [](auto a, auto b) { return a.first > b.first; });
    std::vector<Vec2> corners;
    double sum = 0;
    for (const auto& [value, i] : pixels) {
        if (sum >= mass) break;
        sum += static_cast<double>(value);
        const int row = i / volume.cols;
        const Vec2 at{static_cast<double>(i % volume.cols), static_cast<double>(row)};
        for (const Vec2 corner : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}})
            corners.push_back(at + corner);
    }
    return corners;
}

/// The convex hull of a region and the faces, inside the core.
Polygon with_faces(const Polygon& region, std::span<const Box> faces, const Box& core) {
    std::vector<Vec2> points(region.begin(), region.end());
    for (const Box& face : faces) {
        const Box inside = intersection(face, core);
        if (inside.is_empty()) continue;
        for (const Vec2 corner : to_polygon(inside))
            points.push_back(corner);
    }
    return convex_hull(points);
}

/// The region, grown about its centre where it is too small; grown more where the core's edge cuts it again.
Polygon at_least(Polygon region, double min_region_area, const Box& core) {
    constexpr int max_steps = 32;
    for (int i = 0; i < max_steps; ++i) {
        const double now = area(region);
        if (now >= min_region_area || now <= 0) break;
        const double scale = 1.02 * std::sqrt(min_region_area / now);
        region = clipped(transformed(region, scale, centroid(region) * (1 - scale)), core);
    }
    return region;
}

Polygon smallest_region(const SaliencyMap& volume, const Box& core, std::span<const Box> faces,
                        const RegionSettings& settings) {
    const auto whole = static_cast<double>(volume.total());
    const PeelLimits limits{.safe_mass = settings.safe_mass,
                            .tight_mass = settings.mass,
                            .tight_area = settings.tight_area,
                            .max_area = max_area,
                            .whole = faces};
    const Polygon tight = peeled(volume, core, limits);
    if (area(tight) <= 0) return middle_of(core);
    const double margin = settings.margin * std::hypot(volume.cols, volume.rows);
    Polygon region = clipped(widened(tight, margin), core);
    if (area(region) > max_area * whole) region = tight;
    return at_least(with_faces(region, faces, core), min_area * whole, core);
}

/// The outline with its margin, and with all that stays whole.
Polygon outlined(const Polygon& subject, std::span<const Box> faces, const SaliencyMap& volume,
                 const Box& core) {
    const double margin = subject_margin * std::hypot(volume.cols, volume.rows);
    return with_faces(clipped(widened(subject, margin), core), faces, core);
}

}  // namespace

Polygon i_region(const SaliencyMap& volume, const Box& core, std::span<const Box> faces,
                 const RegionSettings& settings) {
    const double mass = cv::sum(volume)[0];
    Polygon region;
    if (mass <= 0) {
        region = middle_of(core);
    } else if (settings.mode == RegionMode::hull) {
        region = clipped(convex_hull(top_pixels(volume, settings.mass * mass)), core);
    } else {
        region = smallest_region(volume, core, faces, settings);
    }
    if (area(region) <= 0) region = middle_of(core);
    return simplified_within(region, max_corners, core);
}

Polygon subject_region(const SubjectOutline& subject, const SaliencyMap& volume, const Box& core,
                       std::span<const Box> faces, const RegionSettings& settings) {
    const bool is_sure = subject.certainty >= sure_certainty;
    const Polygon& outline = is_sure ? subject.sure : subject.possible;
    Polygon region = area(outline) > 0 ? outlined(outline, faces, volume, core) : Polygon{};
    if (!is_sure) {
        RegionSettings wide = settings;
        if (subject.certainty < blind_certainty) wide.tight_area = 0;  // nearly all is kept
        const Polygon plain = i_region(volume, core, faces, wide);
        region.insert(region.end(), plain.begin(), plain.end());
        region = convex_hull(region);
    }
    if (area(region) <= 0) return i_region(volume, core, faces, settings);
    const double min_region_area = subject_min_area * static_cast<double>(volume.total());
    return simplified_within(at_least(region, min_region_area, core), max_corners, core);
}

}  // namespace vitrine::analyzer
