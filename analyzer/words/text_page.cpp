#include "analyzer/words/text_page.hpp"

#include "base/geometry/convex_hull.hpp"

#include <algorithm>

namespace vitrine::analyzer {
namespace {

constexpr double min_height = 0.02;      // of a line, share of the picture's shorter side
constexpr double min_of_tallest = 0.15;  // of a line, share of the tallest line's height
constexpr std::size_t min_lines = 3;     // of a page
constexpr double min_filled = 0.25;      // of a page, share of its hull that is lines
constexpr double min_page = 0.15;        // share of the picture

/// A line's height; of one that stands upright, its width.
double height_of(const Box& line) {
    return std::min(line.width(), line.height());
}

}  // namespace

std::vector<Box> readable_lines(std::span<const Box> lines, Vec2 picture) {
    double tallest = 0;
    for (const Box& line : lines)
        tallest = std::max(tallest, height_of(line));
    const double least = std::max(min_height * std::min(picture.x, picture.y), min_of_tallest * tallest);
    std::vector<Box> readable;
    for (const Box& line : lines)
        if (height_of(line) >= least) readable.push_back(line);
    return readable;
}

Polygon text_page(std::span<const Box> lines, Vec2 picture) {
    if (lines.size() < min_lines) return {};
    std::vector<Vec2> corners;
    double filled = 0;
    for (const Box& line : lines) {
        corners.insert(corners.end(),
                       {line.min, {line.max.x, line.min.y}, line.max, {line.min.x, line.max.y}});
        filled += line.area();
    }
    Polygon hull = convex_hull(corners);
    const bool is_page = filled >= min_filled * area(hull) && area(hull) >= min_page * picture.x * picture.y;
    return is_page ? hull : Polygon{};
}

}  // namespace vitrine::analyzer
