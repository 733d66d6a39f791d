#include "analyzer/tapestry/synthesis/zoom_synthesis.hpp"

#include "tests/analyzer/tapestry/synthesis/drawn_levels.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>

namespace vitrine::analyzer {
namespace {

constexpr int between = 7;

/// Grey levels.
double mean_difference(const cv::Mat& a, const cv::Mat& b) {
    cv::Mat difference;
    cv::absdiff(a, b, difference);
    const cv::Scalar means = cv::mean(difference);
    return (means[0] + means[1] + means[2]) / 3;
}

/// Both strips as one part, and the flow between them.
struct Zoomed : DrawnLevels {
    explicit Zoomed(int stripe_steps = 0) : DrawnLevels({60, 32}, stripe_steps) {
        ZoomFlow flow(tapestry, 1);
        const ZoomFlow::Part all{
            .coarse = {0, coarse.cols}, .fine = {0, fine.cols}, .used = {0, coarse.cols}};
        islands = flow.match(all, coarse, fine);
        flow.fill();
        part = zoom_part(tapestry, 1, all, {coarse, fine}, islands);
        warps = std::make_unique<ZoomWarps>(flow, tapestry, 1);
    }

    ZoomPictures synthesised() const { return synthesised_zoom(part, *warps, {}, {.between = between}); }

    ZoomPictures bent() const { return bent_zoom(part, *warps, between); }

    /// Bends a picture to the moment of another one.
    cv::Mat carried(const ZoomPictures& pictures, std::size_t from, std::size_t to) const {
        const double step = 1.0 / (between + 1);
        const cv::Mat places = warps->fine.places({0, pictures[to].cols}, step * static_cast<double>(to),
                                                  step * static_cast<double>(from));
        return vitrine::analyzer::bent(pictures[from], places);
    }

    Islands islands;
    ZoomPart part;
    std::unique_ptr<ZoomWarps> warps;
};

}  // namespace

TEST_CASE("a zoom begins and ends with the levels' own pixels and widens evenly in between") {
    const Zoomed zoomed;
    for (const ZoomPictures& pictures : {zoomed.synthesised(), zoomed.bent()}) {
        REQUIRE(pictures.size() == between + 2);
        CHECK(cv::norm(pictures.front(), zoomed.coarse, cv::NORM_INF) == 0);
        CHECK(cv::norm(pictures.back(), zoomed.fine, cv::NORM_INF) == 0);
        for (std::size_t i = 0; i < pictures.size(); ++i)
            CHECK(pictures[i].cols == 150 + 120 * static_cast<int>(i) / (between + 1));
    }
}

TEST_CASE("what both levels show goes from its one place to its other one at a constant speed") {
    const Zoomed zoomed;
    const ZoomPictures pictures = zoomed.synthesised();
    for (std::size_t k = 0; k < zoomed.kept.size(); ++k) {
        const double from = zoomed.tapestry.middle(0, k);
        const double to = zoomed.tapestry.middle(1, static_cast<std::size_t>(zoomed.kept[k]));
        const cv::Size seen(30, 20);  // part of the brick's 60 x 32
        const int top =
            zoomed.brick.height * static_cast<int>(k % 2) + (zoomed.brick.height - seen.height) / 2;
        const cv::Mat brick = zoomed.coarse(cv::Rect({static_cast<int>(from) - seen.width / 2, top}, seen));
        for (const std::size_t i : {1U, 3U, 5U, 7U}) {
            CAPTURE(k);
            CAPTURE(i);
            const double share = static_cast<double>(i) / (between + 1);
            const int middle = static_cast<int>(std::lround((1 - share) * from + share * to));
            const cv::Mat there = pictures[i](cv::Rect({middle - seen.width / 2, top}, seen));
            CHECK(mean_difference(there, brick) < 5);
        }
    }
}

TEST_CASE("between the levels nothing jumps, and neither do the ends") {
    const Zoomed zoomed;
    const ZoomPictures pictures = zoomed.synthesised();
    for (std::size_t i = 0; i + 1 < pictures.size(); ++i) {
        CAPTURE(i);
        CHECK(mean_difference(pictures[i + 1], zoomed.carried(pictures, i, i + 1)) < 8);
    }
}

TEST_CASE("what is synthesised is of the levels' patches, where a flow bends them") {
    const Zoomed zoomed(60);  // a flow makes these stripes narrow
    const auto strangeness = [&](const cv::Mat& picture) {
        const PatchImage target(picture);
        const PatchImage source(zoomed.fine);
        const PatchRules rules = free_rules(source);
        PatchMatch matches(source, target, rules);
        matches.refresh(run_in_order);
        for (std::uint32_t round = 0; round < 6; ++round)
            matches.search(128, round, run_in_order);
        return matches.energy();
    };
    constexpr int more = 15;  // in small steps
    const ZoomPictures synthesised = synthesised_zoom(zoomed.part, *zoomed.warps, {}, {.between = more});
    const ZoomPictures bent = bent_zoom(zoomed.part, *zoomed.warps, more);
    CHECK(strangeness(synthesised[(more + 1) / 4]) < 0.9 * strangeness(bent[(more + 1) / 4]));
}

TEST_CASE("parts beside each other agree where they meet") {
    const Zoomed zoomed;
    const ZoomFlow::Part first{.coarse = {0, 120}, .fine = {0, 250}, .used = {0, 75}};
    const ZoomFlow::Part second{.coarse = {30, 150}, .fine = {20, 270}, .used = {75, 150}};
    const auto islands = [&](const cv::Range& columns, int shift) {
        Islands part{.number = zoomed.islands.number.colRange(columns).clone(),
                     .place = zoomed.islands.place.colRange(columns).clone()};
        part.place -= cv::Scalar(shift, 0);
        return part;
    };
    const ZoomPart left = zoom_part(zoomed.tapestry, 1, first, {zoomed.coarse, zoomed.fine},
                                    islands(first.coarse, first.fine.start));
    const ZoomPart right = zoom_part(zoomed.tapestry, 1, second, {zoomed.coarse, zoomed.fine},
                                     islands(second.coarse, second.fine.start));
    REQUIRE(left.overlap == 45);
    REQUIRE(right.overlap == 0);
    const ZoomRules rules{.between = 3};
    const ZoomPictures pictures = synthesised_zoom(left, *zoomed.warps, {}, rules);
    ZoomPictures shared;
    for (const cv::Mat& picture : pictures)
        shared.push_back(picture.colRange(picture.cols - left.overlap, picture.cols));
    const ZoomPictures beside = synthesised_zoom(right, *zoomed.warps, shared, rules);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        CHECK(left.columns(0.25 * static_cast<double>(i)).end - left.overlap ==
              right.columns(0.25 * static_cast<double>(i)).start);
        CHECK(cv::norm(beside[i].colRange(0, left.overlap / 2), shared[i].colRange(0, left.overlap / 2),
                       cv::NORM_INF) <= 1);
    }
}

TEST_CASE("levels that have nothing in common go over all the same") {
    Zoomed zoomed;
    cv::theRNG().state = 7;
    cv::randu(zoomed.part.coarse, 0, 256);
    zoomed.part.islands.number.setTo(0);
    const ZoomPictures pictures = zoomed.synthesised();
    CHECK(mean_difference(pictures[0], zoomed.carried(pictures, 1, 0)) <
          0.6 * mean_difference(pictures[0], zoomed.carried(pictures, between + 1, 0)));
    CHECK(mean_difference(pictures[between + 1], zoomed.carried(pictures, between, between + 1)) < 8);
}

}  // namespace vitrine::analyzer
