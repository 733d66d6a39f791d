// Tells transitions from other changes on drawn films.

#include "tests/analyzer/film/drawn_scenes.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace vitrine;
using namespace vitrine::analyzer;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

namespace {

const std::vector one_shot{shot(0, 90, ShotEnd::end)};

// b over a, the edge having run over so much of the width.
cv::Mat wiped(const cv::Mat& a, const cv::Mat& b, double share) {
    cv::Mat out = a.clone();
    const int edge = static_cast<int>(std::lround(share * a.cols));
    if (edge > 0) b.colRange(0, edge).copyTo(out.colRange(0, edge));
    return out;
}

// A window of the scene's size onto a larger view, about its middle.
cv::Mat zoomed(const cv::Mat& view, double zoom) {
    const cv::Size2d span(view.cols / zoom, view.rows / zoom);
    const cv::Rect2d part((view.cols - span.width) / 2, (view.rows - span.height) / 2, span.width,
                          span.height);
    cv::Mat out;
    cv::resize(view(part), out, scene_size, 0, 0, cv::INTER_AREA);
    return out;
}

}  // namespace

TEST_CASE("several flashes, also white ones, end no shot") {
    const auto shots = shots_of(90, [](int i) {
        const bool is_bright = i == 30 || i == 31 || i == 38 || i == 50;
        return is_bright ? warm() + cv::Scalar(250, 250, 250) : warm();
    });
    CHECK(shots == one_shot);
}

TEST_CASE("a zoom is one shot") {
    const cv::Mat view = scene(7, {60, 60, 60}, {640, 360});
    const auto shots = shots_of(90, [&](int i) { return zoomed(view, 1 + i / 40.0); });
    CHECK(shots == one_shot);
}

TEST_CASE("a shaken camera is one shot") {
    const cv::Mat view = scene(7, {60, 60, 60}, {320, 180});
    const auto shots = shots_of(90, [&](int i) {
        const cv::Point at(static_cast<int>(60 + 7 * std::sin(i * 1.3)),
                           static_cast<int>(40 + 5 * std::cos(i * 1.7)));
        return view(cv::Rect(at, scene_size)).clone();
    });
    CHECK(shots == one_shot);
}

TEST_CASE("what passes close by ends no shot") {
    const auto shots = shots_of(90, [](int i) {
        cv::Mat picture = warm();
        const cv::Rect thing(-80 + (i - 40) * 20, 15, 80, 75);  // from edge to edge in half a second
        picture(thing & cv::Rect({}, scene_size)).setTo(cv::Scalar(200, 40, 40));
        return picture;
    });
    CHECK(shots == one_shot);
}

TEST_CASE("light that goes up slowly ends no shot") {
    const auto shots = shots_of(90, [](int i) { return warm() * (.5 + .5 * progress(i, 30, 50)); });
    CHECK(shots == one_shot);
}

TEST_CASE("bars that move in are no transition") {
    const auto shots = shots_of(90, [](int i) {
        cv::Mat picture = warm();
        const int bar = static_cast<int>(11 * progress(i, 30, 45));
        picture.rowRange(0, bar).setTo(cv::Scalar::all(0));
        picture.rowRange(scene_size.height - bar, scene_size.height).setTo(cv::Scalar::all(0));
        return picture;
    });
    CHECK(shots == one_shot);
}

TEST_CASE("the same scene from closer is another shot") {
    const cv::Mat view = scene(8, {60, 60, 60}, {640, 360});
    const auto shots = shots_of(90, [&](int i) { return zoomed(view, i < 45 ? 1 : 2.5); });
    CHECK(shots == std::vector{shot(0, 45, ShotEnd::cut), shot(45, 90, ShotEnd::end)});
}

TEST_CASE("a cut between pictures of equal light is found by their colours") {
    const cv::Mat reddish(scene_size, CV_8UC3, cv::Scalar(50, 70, 190));
    const cv::Mat greenish(scene_size, CV_8UC3, cv::Scalar(50, 131, 70));
    const auto shots = shots_of(90, [&](int i) { return i < 45 ? reddish : greenish; });
    CHECK(shots == std::vector{shot(0, 45, ShotEnd::cut), shot(45, 90, ShotEnd::end)});
}

TEST_CASE("a short shot put into another begins what follows") {
    const auto shots = shots_of(100, [](int i) { return i < 45 || i >= 52 ? warm() : cold() * .5; });
    CHECK(shots == std::vector{shot(0, 45, ShotEnd::cut), shot(45, 100, ShotEnd::end)});
}

TEST_CASE("a fade over white ends one shot and begins the next where it is over") {
    const cv::Mat white(scene_size, CV_8UC3, cv::Scalar::all(255));
    const auto shots = shots_of(120, [&](int i) {
        return i < 55 ? mixed(warm(), white, progress(i, 40, 55)) : mixed(white, cold(), progress(i, 55, 70));
    });
    REQUIRE(shots.size() == 2);
    CHECK(shots[0].ends_with == ShotEnd::fade);
    CHECK(is_near(shots[0].end, 40, 5));
    CHECK(is_near(shots[1].begin, 70, 5));
}

TEST_CASE("a scene lit for a moment between two fades is a shot") {
    const auto shots = shots_of(160, [](int i) {
        if (i < 40) return warm();
        if (i < 80) return mixed(black(), scene(5, {20, 130, 60}), progress(i, 50, 72));
        if (i < 110) return mixed(scene(5, {20, 130, 60}), black(), progress(i, 80, 102));
        return cold();
    });
    REQUIRE(shots.size() == 3);
    CHECK(is_near(shots[1].begin, 67, 2));  // lit to three quarters
    CHECK(is_near(shots[1].end, 86, 2));
    CHECK(shots[1].ends_with == ShotEnd::fade);
}

TEST_CASE("black between two cuts belongs to neither shot") {
    const auto shots = shots_of(120, [](int i) { return i < 40 ? warm() : i < 65 ? black() : cold(); });
    REQUIRE(shots.size() == 2);
    CHECK(shots[0].end == 40 * frame_time);
    CHECK(shots[1].begin == 65 * frame_time);
}

TEST_CASE("a wipe in any direction belongs to neither of its shots") {
    for (const int turns : {0, 1, 2, 3}) {
        CAPTURE(turns);
        const auto draw = [&](int i) {
            cv::Mat from = warm();
            cv::Mat to = cold();
            cv::Mat out;
            const bool is_vertical = turns % 2 == 1;
            if (is_vertical) {
                from = from.t();
                to = to.t();
            }
            const double share = progress(i, 40, 60);
            out = turns < 2 ? wiped(from, to, share) : wiped(to, from, 1 - share);
            return is_vertical ? cv::Mat(out.t()) : out;
        };
        const auto shots = shots_of(100, draw);
        REQUIRE(shots.size() == 2);
        CHECK(shots[0].ends_with == ShotEnd::dissolve);
        CHECK(is_near(shots[0].end, 40, 4));
        CHECK(is_near(shots[1].begin, 60, 4));
    }
}

TEST_CASE("a wipe is found though both shots move") {
    const cv::Mat from = scene(11, {20, 60, 130}, {480, 90});
    const cv::Mat to = scene(12, {130, 60, 20}, {480, 90});
    const auto shots = shots_of(100, [&](int i) {
        const cv::Rect part({i, 0}, scene_size);
        return wiped(from(part), to(part), progress(i, 40, 60));
    });
    REQUIRE(shots.size() == 2);
    CHECK(is_near(shots[0].end, 40, 5));
    CHECK(is_near(shots[1].begin, 60, 5));
}

TEST_CASE("a dissolve of 600 ms is found at every frame rate, also at a varying one") {
    const auto share_at = [](nanoseconds time) {
        return std::clamp(std::chrono::duration<double>(time - milliseconds(1800)) / milliseconds(600), 0.0,
                          1.0);
    };
    const auto check = [&](int frames, const Timing& time) {
        const auto shots = shots_of(
            frames, [&](int i) { return mixed(warm(), cold(), share_at(time(i))); }, time);
        REQUIRE(shots.size() == 2);
        CHECK(shots[0].ends_with == ShotEnd::dissolve);
        CHECK(std::chrono::abs(shots[0].end - milliseconds(1800)) <= milliseconds(200));
        CHECK(std::chrono::abs(shots[1].begin - milliseconds(2400)) <= milliseconds(200));
    };
    for (const int rate : {12, 24, 30, 60}) {
        CAPTURE(rate);
        check(4 * rate, [&](int i) { return nanoseconds(1'000'000'000LL * i / rate); });
    }
    check(120, [](int i) {
        return nanoseconds(static_cast<std::int64_t>(1e9 * (i / 30.0 + .1 * (1 - std::cos(i / 7.0)))));
    });
}

namespace {

// b over a within a circle about the middle that has grown by so much.
cv::Mat circled(const cv::Mat& a, const cv::Mat& b, double share) {
    cv::Mat mask = cv::Mat::zeros(a.size(), CV_8UC1);
    const cv::Point middle(a.cols / 2, a.rows / 2);
    cv::circle(mask, middle, static_cast<int>(std::lround(share * std::hypot(middle.x, middle.y))), 255,
               cv::FILLED);
    cv::Mat out = a.clone();
    b.copyTo(out, mask);
    return out;
}

// Bars of a ninth of the height above and below.
cv::Mat letterboxed(cv::Mat picture) {
    const int bar = scene_size.height / 9;
    picture.rowRange(0, bar).setTo(cv::Scalar::all(0));
    picture.rowRange(scene_size.height - bar, scene_size.height).setTo(cv::Scalar::all(0));
    return picture;
}

cv::Mat titled(cv::Mat picture) {
    cv::putText(picture, "THE TITLE", {14, 55}, cv::FONT_HERSHEY_DUPLEX, .8, cv::Scalar::all(250), 2);
    return picture;
}

const std::vector two_shots{shot(0, 45, ShotEnd::cut), shot(45, 90, ShotEnd::end)};

}  // namespace

TEST_CASE("a wipe by a circle belongs to neither of its shots, whether it opens or closes") {
    for (const bool opens : {true, false}) {
        for (const int frames : {10, 24}) {
            CAPTURE(opens);
            CAPTURE(frames);
            const auto shots = shots_of(100, [&](int i) {
                const double share = progress(i, 40, 40 + frames);
                return opens ? circled(warm(), cold(), share) : circled(cold(), warm(), 1 - share);
            });
            REQUIRE(shots.size() == 2);
            CHECK(shots[0].ends_with == ShotEnd::dissolve);
            CHECK(is_near(shots[0].end, 40, 6));  // a small circle is hardly seen
            CHECK(is_near(shots[1].begin, 40 + frames, 6));
        }
    }
}

TEST_CASE("a wipe of eight frames is found") {
    const auto shots = shots_of(100, [](int i) { return wiped(warm(), cold(), progress(i, 40, 48)); });
    REQUIRE(shots.size() == 2);
    CHECK(shots[0].ends_with == ShotEnd::dissolve);
    CHECK(is_near(shots[0].end, 40, 3));
    CHECK(is_near(shots[1].begin, 48, 3));
}

TEST_CASE("a dissolve of two frames is found at every frame rate") {
    for (const int rate : {12, 25, 60}) {
        CAPTURE(rate);
        const auto time = [&](int i) { return nanoseconds(1'000'000'000LL * i / rate); };
        const auto shots = shots_of(
            4 * rate, [&](int i) { return mixed(warm(), cold(), progress(i, 2 * rate, 2 * rate + 2)); },
            time);
        REQUIRE(shots.size() == 2);
        CHECK(shots[0].ends_with == ShotEnd::dissolve);
        CHECK(std::chrono::abs(shots[0].end - time(2 * rate)) <= 2 * time(1));
        CHECK(std::chrono::abs(shots[1].begin - time(2 * rate + 2)) <= 2 * time(1));
    }
}

TEST_CASE("bars above and below hide no cut") {
    const cv::Mat dull = scene(21, {40, 40, 40}) * .7 + cv::Scalar::all(18);
    const cv::Mat other = scene(22, {40, 40, 40}) * .7 + cv::Scalar::all(18);
    const auto shots = shots_of(90, [&](int i) { return letterboxed((i < 45 ? dull : other).clone()); });
    CHECK(shots == two_shots);
}

TEST_CASE("one title over two shots hides no cut") {
    const cv::Mat one = scene(23, {90, 60, 30}) * .6;
    const cv::Mat other = scene(24, {30, 60, 90}) * .6;
    const auto shots = shots_of(90, [&](int i) { return titled((i < 45 ? one : other).clone()); });
    CHECK(shots == two_shots);
}

TEST_CASE("a blurred picture and a sharp one are two shots") {
    cv::Mat blurred;
    cv::GaussianBlur(scene(25, {20, 40, 60}), blurred, {}, 24);
    const cv::Mat sharp = scene(26, {60, 40, 20});
    for (const bool is_sharp_first : {true, false}) {
        const auto shots =
            shots_of(90, [&](int i) { return (i < 45) == is_sharp_first ? sharp.clone() : blurred.clone(); });
        CHECK(shots == two_shots);
    }
}

TEST_CASE("a cut is found though a logo follows within a second") {
    cv::Mat logo(scene_size, CV_8UC3, cv::Scalar(90, 40, 20));
    cv::putText(logo, "LOGO", {40, 55}, cv::FONT_HERSHEY_DUPLEX, 1, cv::Scalar::all(250), 2);
    const auto shots = shots_of(100, [&](int i) { return i < 45 ? warm() : i < 62 ? cold() : logo.clone(); });
    CHECK(shots ==
          std::vector{shot(0, 45, ShotEnd::cut), shot(45, 62, ShotEnd::cut), shot(62, 100, ShotEnd::end)});
}

TEST_CASE("a fast pan is one shot") {
    const cv::Mat view = scene(27, {60, 60, 60}, {640, 90});
    for (const int frames : {10, 15, 25}) {
        CAPTURE(frames);
        const auto shots = shots_of(90, [&](int i) {
            cv::Mat out = cv::Mat::zeros(scene_size, CV_8UC3);
            for (int j = 0; j < 5; ++j) {  // the shutter is open for half a frame
                const double share = std::clamp((i + j / 10.0 - 40) / frames, 0.0, 1.0);
                const double eased = share * share * (3 - 2 * share);
                const cv::Rect part({static_cast<int>(480 * eased), 0}, scene_size);
                out += view(part) / 5;
            }
            return out;
        });
        CHECK(shots == one_shot);
    }
}
