#include "analyzer/saliency/i_region.hpp"
#include "analyzer/saliency/subject_outline.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

#include <vector>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

const cv::Size size{160, 120};
const Box core{{0, 0}, {160, 120}};

SaliencyMap dark() {
    return SaliencyMap::zeros(size, CV_32FC1);
}

SaliencyMap with_disc(cv::Point centre, int radius, double blur = 0) {
    SaliencyMap map = dark();
    cv::circle(map, centre, radius, 1, cv::FILLED);
    if (blur > 0) cv::GaussianBlur(map, map, {0, 0}, blur);
    return map;
}

/// A plain map that is salient in the right half.
SaliencyMap plain_map() {
    SaliencyMap map = dark();
    map(cv::Rect(90, 30, 50, 60)).setTo(1);
    return map;
}

double share(const Polygon& region) {
    return area(region) / size.area();
}

bool holds(const Polygon& region, Vec2 place) {
    return is_inside_convex(region, place, 0.5);
}

Polygon region_of(const SaliencyMap& map) {
    return subject_region(subject_outline(map), plain_map(), core, {}, {});
}

}  // namespace

TEST_CASE("a clear subject is outlined, and the network is sure") {
    const SubjectOutline outline = subject_outline(with_disc({50, 60}, 20, 1));
    CHECK(outline.certainty > 0.9);
    CHECK(area(outline.sure) == doctest::Approx(20 * 20 * 3.14).epsilon(0.15));
}

TEST_CASE("a small subject is sure though all of it is a blur") {
    CHECK(subject_outline(with_disc({50, 60}, 5, 2)).certainty > 0.88);
}

TEST_CASE("a wide smear is not sure, and a map without anything not at all") {
    CHECK(subject_outline(with_disc({80, 60}, 30, 25)).certainty < 0.8);
    CHECK(subject_outline(dark()).certainty == 0);
    CHECK(subject_outline(dark()).sure.empty());
    // One look of two saw a trace of something in a landscape.
    const SubjectOutline trace = subject_outline(with_disc({50, 60}, 3) * 0.2);
    CHECK(trace.certainty == 0);
    CHECK(trace.sure.empty());
}

TEST_CASE("two subjects are one outline, a speck is none") {
    SaliencyMap map = with_disc({30, 60}, 12);
    cv::circle(map, {120, 60}, 12, 1, cv::FILLED);
    const Polygon both = subject_outline(map).sure;
    CHECK(holds(both, {30, 60}));
    CHECK(holds(both, {120, 60}));
    SaliencyMap specked = with_disc({30, 60}, 12);
    specked.at<float>(5, 150) = 1;
    CHECK_FALSE(holds(subject_outline(specked).sure, {150, 5}));
}

TEST_CASE("what is faint about a subject is its surroundings, what is faint beside it is one more thing") {
    SaliencyMap map = dark();
    map(cv::Rect(30, 40, 60, 40)).setTo(0.3);  // one of the two looks saw a part of this
    cv::circle(map, {50, 60}, 15, 1, cv::FILLED);
    cv::circle(map, {140, 20}, 10, 0.3, cv::FILLED);
    const Polygon sure = subject_outline(map).sure;
    CHECK(holds(sure, {50, 60}));
    CHECK(holds(sure, {140, 20}));
    CHECK_FALSE(holds(sure, {32, 42}));
    CHECK_FALSE(holds(sure, {32, 78}));
    CHECK_FALSE(holds(sure, {88, 78}));
}

TEST_CASE("the region of a sure subject follows its size, down to a twentieth of the picture") {
    const Polygon small = region_of(with_disc({40, 60}, 12, 1));
    CHECK(share(small) < 0.09);
    CHECK(holds(small, {40, 60}));
    CHECK_FALSE(holds(small, {115, 60}));  // the plain region is not joined
    CHECK(share(region_of(with_disc({40, 60}, 3, 0))) >= 0.05 - 1e-9);
    SaliencyMap most = dark();
    most(cv::Rect(5, 5, 150, 110)).setTo(1);
    CHECK(share(region_of(most)) > 0.85);
}

TEST_CASE("a subject at an edge takes the region to that edge, and a rectangle keeps its corners") {
    SaliencyMap map = dark();
    map(cv::Rect(40, 60, 60, 60)).setTo(1);
    const Polygon region = region_of(map);
    CHECK(holds(region, {70, 119.9}));
    for (const Vec2 corner : {Vec2{40, 60}, Vec2{100, 60}, Vec2{40, 119}, Vec2{100, 119}})
        CHECK(holds(region, corner));
}

TEST_CASE("where the network doubts, the plain region counts too; where nothing stands out it is large") {
    SaliencyMap doubtful = with_disc({40, 60}, 30, 18);
    const SubjectOutline outline = subject_outline(doubtful);
    REQUIRE(outline.certainty < sure_certainty);
    const Polygon region = region_of(doubtful);
    CHECK(holds(region, {40, 60}));
    CHECK(holds(region, {115, 60}));
    const SaliencyMap faint(size, CV_32FC1, cv::Scalar(1));  // a plain map without a subject
    const Polygon large = subject_region(subject_outline(dark()), faint, core, {}, {});
    CHECK(share(large) > 0.7);
}

TEST_CASE("faces stay whole beside a sure subject") {
    const std::vector<Box> faces{{{130, 10}, {150, 35}}};
    const Polygon region =
        subject_region(subject_outline(with_disc({40, 80}, 12, 1)), plain_map(), core, faces, {});
    CHECK(holds(region, {150, 10}));
    CHECK(holds(region, {40, 80}));
}
