#include "bench/analysis/region_score.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>
#include <vips/vips.h>

#include <algorithm>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

cv::Mat picture(const fs::path& path, int side) {
    VipsImage* image = nullptr;
    if (vips_thumbnail(path.c_str(), &image, side, "height", side, "size", VIPS_SIZE_DOWN, nullptr) != 0)
        return {};
    VipsImage* rgb = nullptr;
    const int failed = vips_colourspace(image, &rgb, VIPS_INTERPRETATION_sRGB, nullptr);
    g_object_unref(image);
    VipsImage* three = nullptr;
    if (failed != 0 || vips_extract_band(rgb, &three, 0, "n", 3, nullptr) != 0) {
        fmt::print("'{}': {}\n", path.string(), vips_error_buffer());
        return {};
    }
    g_object_unref(rgb);
    std::size_t size = 0;
    void* data = vips_image_write_to_memory(three, &size);
    cv::Mat result;
    cv::cvtColor(cv::Mat(three->Ysize, three->Xsize, CV_8UC3, data), result, cv::COLOR_RGB2BGR);
    g_free(data);
    g_object_unref(three);
    return result;
}

std::vector<Box> boxes(const nlohmann::json& entry, const char* key) {
    std::vector<Box> result;
    if (!entry.contains(key)) return result;
    for (const auto& b : entry[key]) {
        result.push_back(
            {{b[0].get<double>(), b[1].get<double>()}, {b[2].get<double>(), b[3].get<double>()}});
    }
    return result;
}

cv::Mat filled(cv::Size size, const std::vector<Box>& fractions) {
    cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
    for (const Box& b : fractions) {
        const cv::Point from(static_cast<int>(b.min.x * size.width), static_cast<int>(b.min.y * size.height));
        const cv::Point to(static_cast<int>(b.max.x * size.width), static_cast<int>(b.max.y * size.height));
        mask(cv::Rect(from, to) & cv::Rect({}, size)).setTo(255);
    }
    return mask;
}

cv::Mat filled(cv::Size size, const Polygon& polygon) {
    std::vector<cv::Point> points;
    for (const Vec2 p : polygon)
        points.emplace_back(cv::Point2d(p.x - 0.5, p.y - 0.5));
    cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
    cv::fillConvexPoly(mask, points, 255);
    return mask;
}

void RegionScore::add(const RegionScore& s) {
    iou += s.iou;
    coverage += s.coverage;
    area += s.area;
    whole_faces += s.whole_faces;
    faces += s.faces;
    ++count;
}

RegionScore region_score(const Polygon& region, cv::Size size, const cv::Mat& subject, const cv::Mat& ignored,
                         const std::vector<Box>& faces) {
    cv::Mat mine = filled(size, region);
    RegionScore s{.area = cv::countNonZero(mine) / static_cast<double>(mine.total())};
    mine.setTo(0, ignored & ~subject);
    const int both = cv::countNonZero(mine & subject);
    s.iou = both / static_cast<double>(std::max(1, cv::countNonZero(mine | subject)));
    s.coverage = both / static_cast<double>(std::max(1, cv::countNonZero(subject)));
    s.faces = static_cast<int>(faces.size());
    for (const Box& face : faces) {
        const Polygon corners = to_polygon(face);
        s.whole_faces += std::all_of(corners.begin(), corners.end(), [&](Vec2 p) {
            return is_inside_convex(region, {p.x * size.width, p.y * size.height}, 1.5);
        });
    }
    return s;
}

}  // namespace vitrine::analyzer
