#include "analyzer/tapestry/synthesis/zoom_warp.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {

namespace {

constexpr double pixel_middle = 0.5;
constexpr double on_edge = 1e-4;             // share of a triangle: a point so close outside counts as inside
constexpr double min_triangle_area = 1e-12;  // squared px

/// The pixels whose middles lie between two coordinates, within [0, end).
cv::Range pixels_between(double from, double to, int end) {
    return {std::clamp(static_cast<int>(std::floor(from - pixel_middle)), 0, end),
            std::clamp(static_cast<int>(std::ceil(to + pixel_middle)), 0, end)};
}

}  // namespace

ZoomWarp::ZoomWarp(const ZoomFlow& flow, const Tapestry& tapestry, std::size_t finer, bool is_to_finer)
    : height_(tapestry.height) {
    const std::size_t level = is_to_finer ? finer - 1 : finer;
    std::vector<ZoomField> fields;
    fields.reserve(as_index(tapestry.tiles(level)));
    for (int tile = 0; tile < tapestry.tiles(level); ++tile)
        fields.push_back(flow.field(tile, is_to_finer));
    for (int row = 0; row < ZoomField::rows; ++row) {
        for (std::size_t tile = 0; tile < fields.size(); ++tile) {
            const ZoomField& field = fields[tile];
            const double left = static_cast<double>(tile) * tapestry.tile_width;
            const bool is_last = tile + 1 == fields.size();  // others share their edge with the next
            for (int column = 0; column < field.columns() - (is_last ? 0 : 1); ++column) {
                const Vec2 own = field.point(column, row) + Vec2{left, 0};
                const Vec2 other = field.place(column, row);
                points_.push_back({.coarse = is_to_finer ? own : other,
                                   .fine = is_to_finer ? other : own,
                                   .growth = field.growths[field.number(column, row)]});
            }
        }
    }
    columns_ = static_cast<int>(points_.size()) / ZoomField::rows;
}

cv::Mat ZoomWarp::places(cv::Range columns, double share, double there) const {
    return drawn(columns, share, [&](const Point& point) {
        return point.at(there) - Vec2{pixel_middle, pixel_middle};
    });
}

cv::Mat ZoomWarp::growths(cv::Range columns, double share) const {
    cv::Mat growths;
    cv::extractChannel(drawn(columns, share,
                             [](const Point& point) {
                                 return Vec2{point.growth, 0};
                             }),
                       growths, 0);
    return growths;
}

template <typename ValueOf>
cv::Mat ZoomWarp::drawn(cv::Range columns, double share, const ValueOf& value_of) const {
    cv::Mat picture(height_, columns.size(), CV_32FC2, cv::Scalar::all(0));
    const auto corner = [&](int column, int row) {
        const Point& point = points_[as_index(row) * as_index(columns_) + as_index(column)];
        return Corner{.place = point.at(share), .value = value_of(point)};
    };
    for (int row = 0; row + 1 < ZoomField::rows; ++row) {
        for (int column = 0; column + 1 < columns_; ++column) {
            const Corner upper = corner(column, row);
            const Corner lower = corner(column + 1, row + 1);
            draw({upper, corner(column + 1, row), lower}, columns.start, picture);
            draw({upper, lower, corner(column, row + 1)}, columns.start, picture);
        }
    }
    return picture;
}

/// Draws a triangle whose values change linearly from corner to corner, as on a graphics card.
void ZoomWarp::draw(const std::array<Corner, 3>& corners, int from, cv::Mat& picture) {
    const auto& [a, b, c] = corners;
    const auto [left, right] = std::minmax({a.place.x, b.place.x, c.place.x});
    if (right < from || left > from + picture.cols) return;
    const auto [top, bottom] = std::minmax({a.place.y, b.place.y, c.place.y});
    const Vec2 ab = b.place - a.place;
    const Vec2 ac = c.place - a.place;
    const double area = cross(ab, ac);
    if (std::abs(area) < min_triangle_area) return;
    const cv::Range rows = pixels_between(top, bottom, picture.rows);
    const cv::Range columns = pixels_between(left - from, right - from, picture.cols);
    for (int y = rows.start; y < rows.end; ++y) {
        for (int x = columns.start; x < columns.end; ++x) {
            const Vec2 way = Vec2{from + x + pixel_middle, y + pixel_middle} - a.place;
            const double of_b = cross(way, ac) / area;
            const double of_c = cross(ab, way) / area;
            if (of_b < -on_edge || of_c < -on_edge || of_b + of_c > 1 + on_edge) continue;
            const Vec2 value = a.value * (1 - of_b - of_c) + b.value * of_b + c.value * of_c;
            picture.at<cv::Vec2f>(y, x) = {static_cast<float>(value.x), static_cast<float>(value.y)};
        }
    }
}

}  // namespace vitrine::analyzer
