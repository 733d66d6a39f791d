#include "analyzer/film/active_picture.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

using namespace vitrine::analyzer;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;

namespace {

constexpr int film_width = 320, film_height = 180;
constexpr milliseconds sample_interval{200};

/// A picture with detail everywhere, another one for each number.
cv::Mat detailed_picture(int number) {
    cv::Mat picture(film_height, film_width, CV_8UC3);
    cv::RNG random(static_cast<std::uint64_t>(number) + 1);
    random.fill(picture, cv::RNG::UNIFORM, 60, 230);
    cv::GaussianBlur(picture, picture, {9, 9}, 0);
    return picture + cv::Scalar(10, 30, 20);
}

/// Covers all but a part with a colour and the noise of a coder.
cv::Mat with_bars(cv::Mat picture, const cv::Rect& active, const cv::Scalar& colour = {16, 16, 16}) {
    cv::Mat bars(picture.size(), CV_8UC3, colour), noise(picture.size(), CV_8UC3);
    cv::theRNG().fill(noise, cv::RNG::UNIFORM, 0, 5);
    bars += noise;
    picture(active).copyTo(bars(active));
    return bars;
}

const cv::Rect letterbox(0, 22, film_width, 136);
const cv::Rect pillarbox(40, 0, 240, film_height);
const cv::Rect all_of_it(0, 0, film_width, film_height);

/// Pushes a shot of five seconds and closes it.
template <typename Draw> cv::Rect closed_shot(ActivePictureFinder& finder, int number, const Draw& draw) {
    const nanoseconds begin = seconds(5) * number;
    for (int i = 0; i < 25; ++i)
        finder.add_picture(draw(i), begin + sample_interval * i);
    return finder.close_shot(begin, begin + seconds(5));
}

/// Tests if all of a bar is cut off, and at most two rows of the picture.
void check_near(const cv::Rect& found, const cv::Rect& active) {
    CAPTURE(found);
    CHECK((found & active) == found);
    CHECK(found.width >= active.width - 4);
    CHECK(found.height >= active.height - 4);
}

}  // namespace

TEST_CASE("the bars of a film are found, at two sides and at four, black and in a colour") {
    for (const cv::Rect& active : {letterbox, pillarbox, letterbox & pillarbox})
        for (const cv::Scalar& colour :
             {cv::Scalar(0, 0, 0), cv::Scalar(16, 16, 16), cv::Scalar(120, 30, 10)}) {
            ActivePictureFinder finder;
            check_near(
                closed_shot(finder, 0, [&](int i) { return with_bars(detailed_picture(i), active, colour); }),
                active);
        }
}

TEST_CASE("eight black columns of 720, such as DV films have at each side, are bars") {
    const cv::Rect picture(8, 0, 704, 404);
    ActivePictureFinder finder;
    const auto reduced = [&](int i) {
        cv::Mat large;
        cv::resize(detailed_picture(i), large, {720, 404});
        cv::Mat small;
        cv::resize(with_bars(large, picture, {0, 0, 0}), small, all_of_it.size(), 0, 0, cv::INTER_AREA);
        return small;
    };
    check_near(closed_shot(finder, 0, reduced), {4, 0, 312, film_height});
}

TEST_CASE("a film without bars is left all_of_it") {
    ActivePictureFinder finder;
    CHECK(closed_shot(finder, 0, detailed_picture) == all_of_it);
    CHECK(finder.newest() == all_of_it);
}

TEST_CASE("a night sky over a dark street is no bar") {
    ActivePictureFinder finder;
    const auto night = [](int i) {
        cv::Mat picture(film_height, film_width, CV_8UC3, cv::Scalar(8, 6, 6));
        for (int x = 0; x < film_width; x += 16)  // roofs of different heights
            cv::rectangle(picture, {x, 40 + (x * 7) % 60}, {x + 15, 130 + (x * 5) % 20},
                          cv::Scalar(90, 100, 120 + i), cv::FILLED);
        return picture;
    };
    CHECK(closed_shot(finder, 0, night) == all_of_it);
}

TEST_CASE("a title on a black ground is no picture within bars") {
    ActivePictureFinder finder;
    const auto title = [](int) {
        cv::Mat picture(film_height, film_width, CV_8UC3, cv::Scalar::all(0));
        cv::putText(picture, "The Tramp", {70, 100}, cv::FONT_HERSHEY_SIMPLEX, 1.2, {230, 230, 230}, 2);
        return picture;
    };
    CHECK(closed_shot(finder, 0, title) == all_of_it);
}

TEST_CASE("a logo over a line on a black ground is no picture within bars") {
    ActivePictureFinder finder;
    const auto logo = [](int) {
        cv::Mat picture(film_height, film_width, CV_8UC3, cv::Scalar::all(0));
        cv::circle(picture, {160, 60}, 25, cv::Scalar::all(235), 3);
        cv::rectangle(picture, cv::Rect(118, 112, 86, 2), cv::Scalar::all(235), cv::FILLED);
        return picture;
    };
    CHECK(closed_shot(finder, 0, logo) == all_of_it);
}

TEST_CASE("a band at one side only is part of the picture") {
    ActivePictureFinder finder;
    const cv::Rect above(0, 0, film_width, 130);
    CHECK(closed_shot(finder, 0, [&](int i) { return with_bars(detailed_picture(i), above); }) == all_of_it);
}

TEST_CASE("words in a bar keep it: they are part of what is shown") {
    ActivePictureFinder finder;
    const auto subtitled = [](int i) {
        cv::Mat picture = with_bars(detailed_picture(i), letterbox);
        if (i > 8) cv::putText(picture, "Hello", {120, 175}, cv::FONT_HERSHEY_SIMPLEX, 0.4, {240, 240, 240});
        return picture;
    };
    const cv::Rect found = closed_shot(finder, 0, subtitled);
    CHECK(found.br().y == film_height);
}

TEST_CASE("a dark shot takes the bars of the others, also of those that come later") {
    ActivePictureFinder finder;
    const auto dark = [](int) { return cv::Mat(film_height, film_width, CV_8UC3, cv::Scalar::all(14)); };
    CHECK(closed_shot(finder, 0, dark) == all_of_it);
    check_near(closed_shot(finder, 1, [](int i) { return with_bars(detailed_picture(i), letterbox); }),
               letterbox);
    check_near(closed_shot(finder, 2, dark), letterbox);
    CHECK(closed_shot(finder, 3, detailed_picture) == all_of_it);
    const std::vector<cv::Rect> all = finder.all_shots();
    REQUIRE(all.size() == 4);
    CHECK(all[0] == all[1]);
    CHECK(all[3] == all_of_it);
}

TEST_CASE("a film that changes its shape has other bars in each shot") {
    ActivePictureFinder finder;
    check_near(closed_shot(finder, 0, [](int i) { return with_bars(detailed_picture(i), letterbox); }),
               letterbox);
    check_near(closed_shot(finder, 1, [](int i) { return with_bars(detailed_picture(i), pillarbox); }),
               pillarbox);
    CHECK(closed_shot(finder, 2, detailed_picture) == all_of_it);
}

TEST_CASE("a single frame with a flash in its bars does not hide them") {
    ActivePictureFinder finder;
    for (int i = 0; i < 100; ++i)
        finder.add_picture(i == 60 ? detailed_picture(i) : with_bars(detailed_picture(i), letterbox),
                           sample_interval * i);
    check_near(finder.close_shot({}, seconds(20)), letterbox);
}

TEST_CASE("the white border of a scan is cut off, a subject on a white ground is not") {
    const cv::Scalar paper = cv::Scalar::all(240);
    const cv::Rect print(24, 18, film_width - 48, film_height - 36);
    ActivePictureFinder scan;
    scan.add_picture(with_bars(detailed_picture(3), print, paper), {});
    check_near(scan.close_shot({}, nanoseconds(1)), print);

    ActivePictureFinder subject;
    cv::Mat vase(film_height, film_width, CV_8UC3, paper);
    cv::ellipse(vase, {film_width / 2, film_height / 2}, {60, 70}, 0, 0, 360, {40, 90, 160}, cv::FILLED);
    subject.add_picture(vase, {});
    CHECK(subject.close_shot({}, nanoseconds(1)) == all_of_it);
}
