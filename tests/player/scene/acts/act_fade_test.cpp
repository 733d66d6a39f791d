#include "player/scene/acts/act_fade.hpp"

#include "player/scene/acts/wall_act.hpp"

#include <doctest/doctest.h>

#include <memory>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

Frame frame_of(const Box& box, SourceId source) {
    Cell cell{.parts = {to_polygon(box)}};
    return {.canvas = {640, 360},
            .items = {{.source = source,
                       .cell = std::make_shared<const Cell>(cell),
                       .placement = {2, box.min},
                       .picture = {320, 180}}}};
}

const Box whole{{0, 0}, {640, 360}};

}  // namespace

TEST_CASE("what fades out stays where it hangs as the canvas grows to the left, and idle is beside it") {
    const WallAct before{.canvas = {640, 360}, .parts = {{"a/1", {.box = whole}}, {"b/1", {}}}};
    const WallAct next{.canvas = {1300, 360},
                       .parts = {{"a/1", {.box = {{660, 0}, {1300, 360}}}}, {"b/1", {.box = whole}}}};
    ActFade fade;
    Frame frame = frame_of({{-200, 0}, {640, 360}}, 1);  // it goes beyond the canvas
    fade.draw(frame, 0s);
    fade.begin({}, place_on(before, next), 1s);
    frame = frame_of({{0, 0}, {1300, 360}}, 2);
    fade.draw(frame, 1s);
    REQUIRE(frame.items.size() == 2);
    CHECK(frame.items[0].source == 1);
    CHECK(frame.items[0].placement == Placement{2, {460, 0}});
    CHECK(bounding_box(frame.items[0].cell->parts[0]) == Box{{660, 0}, {1300, 360}});
    CHECK(frame.idle == 1);
}

TEST_CASE("a canvas with twice the px shows what fades out twice as large, in place of a view that moves") {
    const WallAct before{.canvas = {640, 360}, .parts = {{"a/1", {.box = whole}}}};
    const WallAct next{.canvas = {1280, 720}, .parts = {{"a/1", {.box = {{0, 0}, {1280, 720}}}}}};
    ActFade fade;
    Frame frame = frame_of({{100, 0}, {740, 360}}, 1);
    frame.view = {100, 0};
    fade.draw(frame, 0s);
    fade.begin({50, 0}, place_on(before, next), 1s);
    frame = frame_of(whole, 2);
    fade.draw(frame, 1s);
    CHECK(frame.items[0].placement == Placement{4, {50, 0}});
}

TEST_CASE("on the same canvas what fades out stays as it is, and nothing is drawn below it") {
    const WallAct act{.canvas = {640, 360}};
    ActFade fade;
    Frame frame = frame_of(whole, 1);
    const std::shared_ptr<const Cell> cell = frame.items[0].cell;
    fade.draw(frame, 0s);
    fade.begin({}, place_on(act, act), 1s);
    frame = frame_of(whole, 2);
    fade.draw(frame, 1s);
    CHECK(frame.items[0].cell == cell);
    CHECK(frame.idle == 0);
}

TEST_CASE("what fades out is gone as the canvas becomes another one") {
    const WallAct act{.canvas = {640, 360}};
    ActFade fade;
    Frame frame = frame_of(whole, 1);
    fade.draw(frame, 0s);
    fade.begin({}, place_on(act, act), 1s);
    frame = frame_of(whole, 2);
    fade.draw(frame, 1100ms);
    CHECK(frame.items.size() == 2);
    frame = frame_of(whole, 2);
    frame.canvas = {1300, 360};
    fade.draw(frame, 1200ms);
    CHECK(frame.items.size() == 1);
    CHECK_FALSE(frame.is_fade);
}
