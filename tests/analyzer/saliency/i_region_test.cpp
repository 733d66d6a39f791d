#include "analyzer/saliency/i_region.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

const Box whole{{0, 0}, {160, 90}};
constexpr double picture_area = 160 * 90;

SaliencyMap disc_with_stray_pixels() {
    SaliencyMap map = SaliencyMap::zeros(90, 160, CV_32FC1);
    cv::circle(map, {100, 40}, 18, 1, cv::FILLED);
    for (const cv::Point stray : {cv::Point(2, 2), cv::Point(157, 3), cv::Point(5, 87)})
        map.at<float>(stray) = 1;
    return map;
}

void check_is_sane(const Polygon& region, const Box& core) {
    CHECK(region.size() >= 3);
    CHECK(region.size() <= 12);
    CHECK(signed_area(region) > 0);
    for (const Vec2 p : region)
        CHECK(is_inside_convex(to_polygon(core), p, 1e-6));
    for (std::size_t i = 0; i < region.size(); ++i)
        CHECK(is_inside_convex(region, region[i], 1e-6));
}

}  // namespace

TEST_CASE("stray pixels blow up the paper's hull and not the smallest region") {
    const SaliencyMap map = disc_with_stray_pixels();
    const Polygon hull = i_region(map, whole, {}, {.mode = RegionMode::hull, .mass = 1});
    const Polygon ours = i_region(map, whole, {}, {});
    CHECK(area(hull) > 0.6 * picture_area);
    CHECK(area(ours) < 0.15 * picture_area);
    check_is_sane(hull, whole);
    check_is_sane(ours, whole);
}

TEST_CASE("the region holds the whole of a subject that stands alone") {
    const Polygon region = i_region(disc_with_stray_pixels(), whole, {}, {});
    for (int degrees = 0; degrees < 360; degrees += 10) {
        const double angle = degrees * CV_PI / 180;
        CHECK(is_inside_convex(region, {100.5 + 18 * std::cos(angle), 40.5 + 18 * std::sin(angle)}, 0.5));
    }
}

TEST_CASE("every face is wholly inside, even where nothing else is salient there") {
    const std::vector<Box> faces{{{10, 60}, {30, 84}}};
    const Polygon region = i_region(disc_with_stray_pixels(), whole, faces, {});
    check_is_sane(region, whole);
    for (const Vec2 corner : to_polygon(faces.front()))
        CHECK(is_inside_convex(region, corner, 1e-6));
}

TEST_CASE("where nothing is salient the middle of the core is the region") {
    const Polygon region = i_region(SaliencyMap::zeros(90, 160, CV_32FC1), whole, {}, {});
    CHECK(area(region) == doctest::Approx(0.36 * picture_area));
    CHECK(centroid(region).x == doctest::Approx(80));
}

TEST_CASE("an all-over texture gets a region of at most 80 % of the picture") {
    cv::Mat map(90, 160, CV_32FC1);
    cv::RNG random(3);
    random.fill(map, cv::RNG::UNIFORM, 0.5, 1.0);
    const Polygon region = i_region(map, whole, {}, {});
    check_is_sane(region, whole);
    CHECK(area(region) <= 0.82 * picture_area);
    CHECK(area(region) >= 0.08 * picture_area);
}

TEST_CASE("saliency that is spread is kept nearly whole, saliency that is gathered tightly enclosed") {
    // Given a broad hill over the whole picture, and a narrow one of the same height.
    const auto hill = [](double width) {
        SaliencyMap map(90, 160, CV_32FC1);
        for (int y = 0; y < map.rows; ++y) {
            for (int x = 0; x < map.cols; ++x) {
                const double r = std::hypot((x - 80) / 160.0, (y - 45) / 90.0) / width;
                map.at<float>(y, x) = static_cast<float>(std::exp(-r * r / 2));
            }
        }
        return map;
    };
    CHECK(area(i_region(hill(0.5), whole, {}, {})) > 0.7 * picture_area);
    const double tight = area(i_region(hill(0.2), whole, {}, {}));
    CHECK(tight < 0.5 * picture_area);
    CHECK(area(i_region(hill(0.1), whole, {}, {})) < 0.6 * tight);
}

TEST_CASE("a speck at the edge still gets a region of 8 % of the picture") {
    SaliencyMap map = SaliencyMap::zeros(90, 160, CV_32FC1);
    map.at<float>(89, 159) = 1;
    const Polygon region = i_region(map, whole, {}, {});
    check_is_sane(region, whole);
    CHECK(area(region) >= 0.08 * picture_area);
}

TEST_CASE("the region never leaves the part that every frame shows") {
    const Box core{{30, 0}, {120, 70}};
    const std::vector<Box> faces{{{10, 50}, {60, 84}}};
    check_is_sane(i_region(disc_with_stray_pixels(), core, faces, {}), core);
}
