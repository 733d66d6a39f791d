#include "player/layout/pack/shape.hpp"

#include "base/geometry/convex_hull.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double min_width = 1;       // source px
constexpr double sliver_ratio = 0.1;  // a region's size is at least this ratio times its length squared
constexpr double max_apart = 2;       // factor by which a region's size may differ from the median

Box thickened(Box box) {
    const Vec2 grow{std::max(0.0, min_width - box.width()) / 2, std::max(0.0, min_width - box.height()) / 2};
    return {box.min - grow, box.max + grow};
}

/// The area of the region that counts for its size, source px^2.
double size_of(const Shape& shape) {
    const double longest = std::max(shape.extent.width(), shape.extent.height());
    return std::max(shape.area, sliver_ratio * longest * longest);
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

Shape shape_of(std::span<const Vec2> region) {
    Polygon outline = convex_hull(region);
    if (outline.empty()) outline = {{0, 0}};
    const Box box = bounding_box(outline);
    if (outline.size() < 3 || area(outline) < min_width * std::max(box.width(), box.height()) / 2)
        outline = to_polygon(thickened(box));
    Shape shape;
    shape.centroid = centroid(outline);
    shape.outline = transformed(outline, 1, shape.centroid * -1);
    shape.extent = bounding_box(shape.outline);
    shape.area = area(shape.outline);
    for (const Vec2& p : shape.outline)
        shape.radius = std::max(shape.radius, length(p));
    return shape;
}

Box bounds_of(const ScaledShapes& shapes, std::span<const Vec2> places) {
    Box all;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Box extent = moved(shapes.extent(i), places[i]);
        all = i == 0 ? extent : united(all, extent);
    }
    return all;
}

std::vector<double> natural_scales(std::span<const LayoutItem> items, std::span<const Shape> shapes) {
    std::vector<double> scales;
    std::vector<double> sizes;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const double size = size_of(shapes[i]);
        scales.push_back(std::sqrt(items[i].weight / std::max(items[i].core.area(), size)));
        sizes.push_back(size * scales[i] * scales[i]);
    }
    if (items.empty()) return scales;
    const double middle = median(sizes);
    for (std::size_t i = 0; i < items.size(); ++i)
        scales[i] *= std::sqrt(std::clamp(sizes[i], middle / max_apart, middle * max_apart) / sizes[i]);
    return scales;
}

}  // namespace vitrine::player
