#include "player/scene/tapestry/tapestry_view.hpp"

#include "tests/player/scene/tapestry/drawn_tapestry.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr Box box{{0, 200}, {320, 290}};  // equally high to the strip: a strip's px is a canvas px

bool is_near(std::chrono::nanoseconds a, std::chrono::nanoseconds b) {
    return std::chrono::abs(a - b) < 1us;
}

}  // namespace

TEST_CASE("a moment is seen where its time is, at every level and between them") {
    const Tapestry tapestry = drawn_tapestry();
    const TapestryPlace place(tapestry, box);
    for (const double level : {0.0, 0.4, 1.0, 1.9, 2.5, 3.0}) {
        const TapestryView view{.centre = 20s, .level = level};
        CHECK(place.canvas_x(view, 20s) == doctest::Approx(160));
        double last = -1e9;
        for (auto time = 0s; time <= 60s; time += 3s) {
            const double x = place.canvas_x(view, time);
            CHECK(x > last);
            CHECK(is_near(place.time_at(view, x), time));
            last = x;
        }
    }
}

TEST_CASE("between two levels everything is between its places on both") {
    const Tapestry tapestry = drawn_tapestry();
    const TapestryPlace place(tapestry, box);
    const auto way = [&](double level, std::chrono::nanoseconds time) {
        const TapestryView view{.centre = 30s, .level = level};
        return place.canvas_x(view, time) - place.canvas_x(view, 30s);
    };
    for (const auto time : {2s, 17s, 44s, 59s})
        CHECK(way(1.25, time) == doctest::Approx(0.75 * way(1, time) + 0.25 * way(2, time)));
    CHECK(place.width(1.5) == doctest::Approx((place.width(1) + place.width(2)) / 2));
}

TEST_CASE("a view shows nothing beside the film, or as little as must be") {
    const Tapestry tapestry = drawn_tapestry();
    const TapestryPlace place(tapestry, box);
    const TapestryView first = place.bounded({.centre = 0s, .level = 3});
    CHECK(place.canvas_x(first, 0s) == doctest::Approx(0));
    const TapestryView last = place.bounded({.centre = 60s, .level = 9});
    CHECK(last.level == 3);
    CHECK(place.canvas_x(last, 60s) == doctest::Approx(320));
    const TapestryView whole = place.bounded({.centre = 3s, .level = -1});  // 250 px of 320
    CHECK(whole.level == 0);
    CHECK(place.canvas_x(whole, 0s) == doctest::Approx(35));
    CHECK(place.canvas_x(whole, 60s) == doctest::Approx(285));
}

TEST_CASE("a strip goes with the finger until its end is there") {
    const Tapestry tapestry = drawn_tapestry();
    const TapestryPlace place(tapestry, box);
    const TapestryView view{.centre = 20s, .level = 2};
    CHECK(place.canvas_x(place.moved(view, 70), 20s) == doctest::Approx(230));
    CHECK(place.canvas_x(place.moved(view, -70), 20s) == doctest::Approx(90));
    CHECK(place.canvas_x(place.moved(view, 1e6), 0s) == doctest::Approx(0));
}

TEST_CASE("what two fingers hold stays below them while the strip becomes longer") {
    const Tapestry tapestry = drawn_tapestry();
    const TapestryPlace place(tapestry, box);
    TapestryView view{.centre = 30s, .level = 2};
    const auto held = place.time_at(view, 90);
    for (double level = 2; level <= 3; level += 0.1) {
        view = place.zoomed(view, level, 90);
        CHECK(place.canvas_x(view, held) == doctest::Approx(90).epsilon(1e-4));
    }
}

TEST_CASE("the pieces of a level cover the box once, each where its tile's pixels belong") {
    const Tapestry tapestry = drawn_tapestry();
    const TapestryPlace place(tapestry, box);
    for (const double level : {1.0, 1.3, 2.0, 2.7}) {
        const TapestryView view = place.bounded({.centre = 30s, .level = level});
        for (const std::size_t drawn :
             {static_cast<std::size_t>(level), static_cast<std::size_t>(std::ceil(level))}) {
            const auto pieces = place.pieces(view, drawn, 0, 320);
            REQUIRE_FALSE(pieces.empty());
            CHECK(pieces.front().left <= 1e-3);
            CHECK(pieces.back().right >= 320 - 1e-3);
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                if (i > 0) CHECK(pieces[i].left == pieces[i - 1].right);
                const double start = pieces[i].tile.tile * 200.0;
                const double width = std::min(200.0, tapestry.levels[drawn].width - start);
                const double x = start + width * (pieces[i].first + pieces[i].last) / 2;
                CHECK(place.canvas_x(view, tapestry.time_at(drawn, x)) ==
                      doctest::Approx((pieces[i].left + pieces[i].right) / 2).epsilon(1e-4));
            }
        }
    }
}

TEST_CASE("at a level itself each tile is one piece") {
    const Tapestry tapestry = drawn_tapestry();
    const TapestryPlace place(tapestry, box);
    const auto pieces = place.pieces({.centre = 30s, .level = 2}, 2, 0, 320);
    CHECK(pieces.size() <= 3);
    for (const TilePiece& piece : pieces)
        CHECK(piece.last - piece.first == 1);
}

TEST_CASE("the first picture is drawn whole where its keyframe is the film's first moment") {
    Tapestry tapestry = drawn_tapestry();
    for (TapestryLevel& level : tapestry.levels)
        level.keyframes.front() = 0s;
    const TapestryPlace place(tapestry, box);
    for (const double level : {1.0, 1.5, 3.0}) {
        const TapestryView view = place.bounded({.centre = 0s, .level = level});
        CHECK(place.canvas_x(view, 0s) == doctest::Approx(0));
        const auto pieces = place.pieces(view, static_cast<std::size_t>(level), 0, 320);
        REQUIRE_FALSE(pieces.empty());
        CHECK(pieces.front().tile.tile == 0);
        CHECK(pieces.front().first == 0);
        CHECK(pieces.front().left == doctest::Approx(0));
    }
}

TEST_CASE("a film of one keyframe has a strip too") {
    Tapestry tapestry = drawn_tapestry(1);
    tapestry.levels[0] = {.width = 100, .keyframes = {1s}};
    tapestry.duration = 2s;
    const TapestryPlace place(tapestry, box);
    const TapestryView view = place.bounded({});
    CHECK(place.canvas_x(view, 0s) == doctest::Approx(110));
    CHECK(place.pieces(view, 0, 0, 320).size() == 1);
    CHECK(place.levels_for(0, 2) == 0);
}

TEST_CASE("before one screen of several a narrow film is in its middle, a wider one fills it") {
    const Tapestry tapestry = drawn_tapestry();
    for (const double from : {0.0, 340.0, 680.0}) {
        const double to = from + 320;
        const TapestryPlace place(tapestry, {{0, 200}, {1000, 290}}, Box{{from, 0}, {to, 300}});
        for (const double level : {0.0, 1.0, 3.0}) {
            for (const auto centre : {0s, 20s, 60s}) {
                const TapestryView view = place.bounded({.centre = centre, .level = level});
                const double left = place.canvas_x(view, 0s);
                const double right = place.canvas_x(view, 60s);
                INFO(from, " ", level, " ", centre.count(), ": ", left, " to ", right);
                if (place.width(level) <= 320) {
                    CHECK(left + right == doctest::Approx(from + to));
                } else {
                    CHECK(left <= from + 1e-6);
                    CHECK(right >= to - 1e-6);
                }
                if (place.width(level) >= 1000) {
                    CHECK(left <= 1e-6);
                    CHECK(right >= 1000 - 1e-6);
                } else {
                    CHECK(left >= -1e-6);
                    CHECK(right <= 1000 + 1e-6);
                }
            }
        }
    }
}
