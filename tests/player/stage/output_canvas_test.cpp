#include "player/stage/output_canvas.hpp"

#include "base/settings/settings.hpp"
#include "player/display/offscreen_display.hpp"

#include <doctest/doctest.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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
    /// @param role  lead: the box is called "here"
    explicit Pair(const std::string& canvas, WallRole role = WallRole::alone) {
        settings.output.canvas = canvas;
        if (role == WallRole::lead) settings.wall = {.role = role, .box = "here"};
    }

    void follow(std::span<Screen* const> screens, std::chrono::nanoseconds now) {
        outputs.follow(screens, now);
    }

    Settings settings;
    OffscreenDisplay display{{.screens = {{100, 50}, {80, 50}}}, {}, 30};
    std::shared_ptr<OtherOutputs> others = std::make_shared<OtherOutputs>();
    OutputCanvas outputs{settings, others};
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

TEST_CASE("an output that gets a place goes on with all of the canvas before") {
    Pair pair("offscreen-1 0,0");
    Screen& second = *pair.display.screens()[1];
    pair.follow(pair.display.screens(), 0s);
    pair.follow(pair.display.screens(), 1s);
    pair.settings.output.canvas = "offscreen-1 0,0; offscreen-2 0,60";
    pair.follow(pair.display.screens(), 2s);
    REQUIRE(pair.outputs.shared().parts.size() == 2);
    CHECK_FALSE(pair.outputs.is_beyond(second, {100, 50}));
    CHECK_FALSE(pair.outputs.view_on(second, {100, 50}).part);
    CHECK(pair.outputs.view_on(second, pair.outputs.shared().canvas).part == Box{{0, 60}, {80, 110}});
}

TEST_CASE("another box whose output gets a place goes on with all of the canvas before") {
    Pair pair("here/offscreen-1 0,0", WallRole::lead);
    const std::vector<Screen*> own{pair.display.screens()[0]};
    pair.others->outputs = {{"there/DP-1", 80, 50, {}}};
    pair.outputs.follow(own, 0s);
    pair.outputs.follow(own, 1s);
    pair.settings.output.canvas = "here/offscreen-1 0,0; there/DP-1 0,60; far/DP-1 0,120";
    pair.outputs.follow(own, 2s);
    const std::vector<ActParts> all = pair.outputs.parts();
    REQUIRE(all.size() == 2);
    CHECK(all[0].parts.at("there/DP-1").box == Box{{0, 60}, {80, 110}});
    CHECK_FALSE(all[1].parts.contains("there/DP-1"));
    CHECK(all[1].parts.at("far/DP-1").box.is_empty());  // it is not there yet
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

TEST_CASE("the guide of one of several boxes shows the name by which output.canvas names its screen") {
    Pair pair("here/offscreen-1 0,0", WallRole::lead);
    pair.follow(pair.display.screens(), 0s);
    CHECK(pair.outputs.guide_view(*pair.display.screens()[0], {100, 50}).name == "here/offscreen-1");
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

TEST_CASE("outputs of other boxes are on the canvas, and a box that is gone keeps its place for a minute") {
    Pair pair("here/offscreen-1 0,0; there/DP-1 110,0 turned 90", WallRole::lead);
    OutputCanvas& outputs = pair.outputs;
    const auto& others = pair.others;
    const std::vector<Screen*> own{pair.display.screens()[0]};
    outputs.follow(own, 0s);
    CHECK(outputs.shared().parts.size() == 1);
    CHECK(outputs.parts().at(0).parts.at("there/DP-1").box.is_empty());
    others->outputs = {{"there/DP-1", 80, 50, {}}};
    outputs.follow(own, 1s);
    CHECK(Vec2(outputs.shared().canvas) == Vec2{160, 80});
    const std::vector<ActParts> all = outputs.parts();
    REQUIRE(all.size() == 2);
    CHECK(all[1].canvas == Vec2{100, 50});  // the wall is seen there until another one is laid out
    CHECK(all[1].parts.at("here/offscreen-1") == ActPart{.box = {{0, 0}, {100, 50}}});
    CHECK(all[1].parts.at("there/DP-1") == ActPart{.box = {{110, 0}, {160, 80}}, .turned = 90});
    CHECK(all[0].canvas == Vec2{160, 80});
    const std::map<std::string, ActPart>& parts = all[0].parts;
    REQUIRE(parts.size() == 2);
    CHECK(parts.at("here/offscreen-1") == ActPart{.box = {{0, 0}, {100, 50}}});
    CHECK(parts.at("there/DP-1") == ActPart{.box = {{110, 0}, {160, 80}}, .turned = 90});
    others->outputs.clear();
    outputs.follow(own, 60s);
    CHECK(outputs.shared().parts.size() == 2);
    outputs.follow(own, 62s);
    CHECK(outputs.shared().parts.size() == 1);
}

TEST_CASE("a leader without outputs lays the canvas out for the other boxes after a minute") {
    Pair pair("here/offscreen-1 0,0; there/DP-1 110,0", WallRole::lead);
    OutputCanvas& outputs = pair.outputs;
    const auto& others = pair.others;
    const std::vector<Screen*> own{pair.display.screens()[0]};
    outputs.follow(own, 0s);
    others->outputs = {{"there/DP-1", 80, 50, {}}};
    outputs.follow(own, 1s);
    outputs.follow({}, 60s);
    CHECK(outputs.shared().parts.size() == 2);
    outputs.follow({}, 61s);
    REQUIRE(outputs.shared().parts.size() == 1);
    CHECK(outputs.shared().parts.contains("there/DP-1"));
    others->outputs.clear();
    outputs.follow({}, 1h);
    CHECK(outputs.shared().parts.size() == 1);
}

TEST_CASE("a box that follows shows the parts that an act gives it") {
    Pair pair("");
    pair.settings.wall = {.role = WallRole::follow, .box = "there"};
    const WallAct act{.canvas = {300, 100},
                      .parts = {{"here/offscreen-1", {.box = {{0, 0}, {100, 100}}}},
                                {"there/offscreen-1", {.box = {{200, 50}, {300, 100}}, .turned = 180}}}};
    pair.outputs.show_parts(act);
    pair.follow(pair.display.screens(), 1s);
    const View view = pair.outputs.view_on(*pair.display.screens()[0], {300, 100});
    CHECK(view.part == Box{{200, 50}, {300, 100}});
    CHECK(view.rotation == Rotation::half);
    CHECK_FALSE(pair.outputs.view_on(*pair.display.screens()[1], {300, 100}).part);
    CHECK_FALSE(pair.outputs.is_beyond(*pair.display.screens()[0], {300, 100}));
    CHECK_FALSE(pair.outputs.is_beyond(*pair.display.screens()[1], {300, 100}));
}

TEST_CASE(
    "an output that joins a canvas at the left hangs beyond the one before, and the others stay there") {
    Pair pair("there/DP-1 -110,0; here/offscreen-1 0,0; here/offscreen-2 120,0", WallRole::lead);
    OutputCanvas& outputs = pair.outputs;
    const auto& others = pair.others;
    outputs.follow(pair.display.screens(), 0s);
    others->outputs = {{"there/DP-1", 100, 50, {}}};
    outputs.follow(pair.display.screens(), 1s);
    CHECK(Vec2(outputs.shared().canvas) == Vec2{310, 50});
    const Vec2 before{200, 50};
    const std::map<std::string, ActPart> parts = outputs.parts()[1].parts;
    CHECK(parts.at("there/DP-1").box == Box{{-110, 0}, {-10, 50}});
    CHECK(parts.at("here/offscreen-2").box == Box{{120, 0}, {200, 50}});
    const Screen& second = *pair.display.screens()[1];
    CHECK(outputs.view_on(second, before).part == Box{{120, 0}, {200, 50}});
    CHECK_FALSE(outputs.is_beyond(second, before));
    CHECK(outputs.view_on(second, {310, 50}).part == Box{{230, 0}, {310, 50}});
}
