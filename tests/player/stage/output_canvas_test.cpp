#include "player/stage/output_canvas.hpp"

#include "base/settings/settings.hpp"
#include "player/display/offscreen_display.hpp"

#include <doctest/doctest.h>

#include <utility>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

SharedCanvas shared(const std::string& text, const std::vector<KnownOutput>& outputs) {
    const CanvasWords words = canvas_named(text);
    CHECK(words.fault.empty());
    return shared_canvas(words, outputs);
}

/// Two screens in memory on one canvas.
struct Pair {
    explicit Pair(const std::string& canvas) { settings.output.canvas = canvas; }

    void follow(std::span<Screen* const> screens, std::chrono::nanoseconds now) {
        outputs.follow(screens, now);
    }

    Settings settings;
    OffscreenDisplay display{{.screens = {{100, 50}, {80, 50}}}, {}, 30};
    OutputCanvas outputs{settings};
};

}  // namespace

TEST_CASE("a canvas in pixels has the size of its outputs' modes and the gap between them") {
    const SharedCanvas found = shared("A 0,0; B 110,0", {{"A", 100, 50, {}}, {"B", 80, 50, {}}});
    CHECK(Vec2(found.canvas) == Vec2{190, 50});
    CHECK(found.parts.at("A").box == Box{{0, 0}, {100, 50}});
    CHECK(found.parts.at("B").box == Box{{110, 0}, {190, 50}});
    CHECK(found.canvas.bands == std::vector<Box>{{{100, 0}, {110, 50}}});
}

TEST_CASE("a canvas in millimetres has as many pixels as its finest output") {
    const SharedCanvas found =
        shared("mm: A 0,0 500x250; B 520,0 500x250", {{"A", 1000, 500, {}}, {"B", 2000, 1000, {}}});
    CHECK(Vec2(found.canvas) == Vec2{4080, 1000});
    CHECK(found.parts.at("B").box == Box{{2080, 0}, {4080, 1000}});
}

TEST_CASE("an output that hangs turned takes a part that is turned") {
    const SharedCanvas found = shared("A 0,0; B 100,0 turned 90", {{"A", 100, 50, {}}, {"B", 80, 50, {}}});
    CHECK(found.parts.at("B") == OutputPart{.box = {{100, 0}, {150, 80}}, .rotation = Rotation::right});
    CHECK(found.canvas.bands == std::vector<Box>{{{0, 50}, {100, 80}}});
    const SharedCanvas all = shared("A 0,0", {{"A", 100, 50, {.rotation = Rotation::left}}});
    CHECK(all.parts.at("A").rotation == Rotation::left);
    CHECK(Vec2(all.canvas) == Vec2{50, 100});
}

TEST_CASE("a canvas is never longer than the packing is exact") {
    const SharedCanvas found =
        shared("mm: A 0,0 500x250; B 9500,0 500x250", {{"A", 4000, 2000, {}}, {"B", 4000, 2000, {}}});
    CHECK(found.canvas.x == doctest::Approx(16384));
}

TEST_CASE("outputs that overlap with their modes are told") {
    CHECK(overlap_of(shared("A 0,0; B 90,0", {{"A", 100, 50, {}}, {"B", 80, 50, {}}})) ==
          "'A' and 'B' overlap");
    CHECK(overlap_of(shared("A 0,0; B 100,0", {{"A", 100, 50, {}}, {"B", 80, 50, {}}})).empty());
}

TEST_CASE("an output that no canvas names shows all of it") {
    Pair pair("offscreen-1 0,0");
    pair.follow(pair.display.screens(), 0s);
    const View view = pair.outputs.view_on(*pair.display.screens()[1], {100, 50});
    CHECK_FALSE(view.part);
    CHECK(view.top + view.bottom == 10);
}

TEST_CASE("an output that is pulled out keeps its place for a minute") {
    Pair pair("offscreen-1 0,0; offscreen-2 110,0");
    const std::vector<Screen*> both(pair.display.screens().begin(), pair.display.screens().end());
    const std::vector<Screen*> second{both[1]};
    pair.follow(both, 0s);
    const SharedCanvas all = pair.outputs.shared();
    REQUIRE(all.parts.size() == 2);
    pair.follow(both, 10s);

    pair.follow(second, 11s);
    pair.follow(second, 69s);
    CHECK(pair.outputs.shared() == all);
    CHECK(pair.outputs.view_on(*second[0], all.canvas).part == Box{{110, 0}, {190, 50}});

    pair.follow(second, 70s);
    CHECK(Vec2(pair.outputs.shared().canvas) == Vec2{80, 50});
    CHECK(pair.outputs.view_on(*second[0], all.canvas).part ==
          Box{{110, 0}, {190, 50}});  // until it is drawn
    CHECK(pair.outputs.view_on(*second[0], {80, 50}).part == Box{{0, 0}, {80, 50}});

    pair.follow(both, 80s);
    CHECK(pair.outputs.shared() == all);
}

TEST_CASE("while no output is there, places are kept") {
    Pair pair("offscreen-1 0,0; offscreen-2 110,0");
    pair.follow(pair.display.screens(), 0s);
    pair.follow({}, 1h);
    CHECK(pair.outputs.shared().parts.size() == 2);
}

TEST_CASE("a canvas that is written anew is followed at once") {
    Pair pair("");
    pair.follow(pair.display.screens(), 0s);
    CHECK_FALSE(pair.outputs.is_shared());
    pair.settings.output.canvas = "offscreen-1 0,0; offscreen-2 100,0";
    pair.follow(pair.display.screens(), 1s);
    CHECK(pair.outputs.is_shared());
    pair.settings.output.canvas = "";
    pair.follow(pair.display.screens(), 2s);
    CHECK_FALSE(pair.outputs.is_shared());
}

TEST_CASE("a guide shows the name, the place and the rulers of its screen in the canvas' units") {
    Pair pair("mm: offscreen-1 10,0 200x100; offscreen-2 230,0 200x100");
    pair.follow(pair.display.screens(), 0s);
    const Vec2 canvas = pair.outputs.shared().canvas;
    const GuideView guide = pair.outputs.guide_view(*pair.display.screens()[1], canvas);
    CHECK(guide.name == "offscreen-2");
    CHECK(guide.unit == doctest::Approx(0.5));
    CHECK(guide.origin == Vec2{10, 0});
    CHECK(guide.part.min.x / guide.unit + guide.origin.x == doctest::Approx(230));
}

TEST_CASE("the diagonal of a canvas goes on from one guide to the next") {
    const Box left{{0, 0}, {320, 240}};
    const Box right{{360, 0}, {680, 240}};
    const auto is_marked = [](const Box& part, Vec2 point) {
        const auto picture =
            canvas_guide({.name = "A", .size = {320, 240}, .part = part, .canvas = {680, 240}});
        REQUIRE(picture->width == 320);
        const auto x = static_cast<std::size_t>(point.x - part.min.x);
        const auto y = static_cast<std::size_t>(point.y);
        return std::to_integer<int>(picture->rgba[(y * 320 + x) * 4]) > 200;
    };
    for (const double x : {100.0, 200.0, 290.0})
        CHECK(is_marked(left, {x, x * 240 / 680}));
    for (const double x : {400.0, 500.0, 640.0})
        CHECK(is_marked(right, {x, x * 240 / 680}));
    CHECK_FALSE(is_marked(left, {100, 70}));
}
