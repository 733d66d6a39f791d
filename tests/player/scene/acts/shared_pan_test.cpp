// Boxes of one wall that pans show the same part of it at the same time, whatever the network does.

#include "player/layout/plan/plan.hpp"
#include "tests/player/scene/acts/shared_house.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr double speed = 100;  // px a second

Layout packed(const WallPlan& wanted) {
    PlanRequest request{.canvas = wanted.canvas, .budget = 3'000, .fills = false};
    request.items = wanted.items;
    Layout layout = plan(request);
    layout.generation = wanted.generation;
    layout.is_final = true;
    return layout;
}

SharedHouse::Options panning(std::uint64_t seed) {
    std::vector<MediaRecord> records = photos(12);
    records.push_back(film("z", 3));
    return {.seed = seed,
            .lay_out = packed,
            .records = std::move(records),
            .pan = PanSettings{.ribbon = {.order = ShotOrder::name, .items_a_screen = 4}, .speed = speed}};
}

/// The place of a shot that both boxes show, px of the canvas. None: there is no such shot.
std::optional<double> place_of(const TestBox& box, const std::string& path) {
    for (const DrawItem& item : box.last.items)
        if (box.playing.at(item.source).path == path) return item.placement.offset.x - box.last.view.x;
    return std::nullopt;
}

/// A shot that a box shows now.
std::string path_of_first(const TestBox& box) {
    REQUIRE(!box.last.items.empty());
    return box.playing.at(box.last.items.front().source).path;
}

void touch(SharedHouse& house, Gesture::Kind kind, double way) {
    house.boxes[0].show->handle_gesture(
        {.kind = kind, .touch = 1, .at = {600 + way, 100}, .from = {600, 100}, .moved = {way, 0}});
}

}  // namespace

TEST_CASE("a panning wall passes on all boxes in step, and few acts tell of it") {
    SharedHouse house(panning(2));
    house.run(60s);
    for (std::size_t i = 1; i < house.boxes.size(); ++i) {
        INFO("box ", i);
        CHECK(share_in_step(house.boxes[0], house.boxes[i], 10s) >= 0.999);
        CHECK(house.boxes[i].back == 0);
        CHECK(house.boxes[i].gaps == 0);
        REQUIRE(house.followed(i).shown() != nullptr);
        CHECK(house.followed(i).shown()->name.generation <= 60);
    }
    CHECK(house.boxes[0].last.view.x + house.followed(1).shown()->pan->origin > 50 * speed);
    CHECK(house.faults == 0);
}

TEST_CASE("cuts of the network stop no panning wall, and it is in step again after them") {
    SharedHouse::Options options = panning(3);
    options.cuts = 0.1;
    SharedHouse house(options);
    house.run(60s);
    for (std::size_t i = 1; i < house.boxes.size(); ++i) {
        CHECK(share_in_step(house.boxes[0], house.boxes[i], 10s) >= 0.9);
        CHECK(house.boxes[i].gaps == 0);
        house.heal(i);
    }
    const Ns healed = house.truth;
    house.run(1500ms);
    for (std::size_t i = 1; i < house.boxes.size(); ++i)
        CHECK(share_in_step(house.boxes[0], house.boxes[i], healed + 300ms) >= 0.96);
}

TEST_CASE("a box that joins a panning wall is in step with its first picture") {
    SharedHouse house(panning(4));
    bring_late_box(house);
    house.boxes[2].frames.clear();
    house.run(6s);
    const ShownFrame* const first = first_picture(house.boxes[2]);
    REQUIRE(first != nullptr);
    CHECK(first->is_whole);
    CHECK(share_in_step(house.boxes[0], house.boxes[2], first->truth) >= 0.999);
}

TEST_CASE("as a display joins a panning wall at the left, what was seen fades out where it hangs") {
    SharedHouse::Options options = panning(9);
    options.followers = 1;
    SharedHouse house(options);
    Show& lead = *house.boxes[0].show;
    const Box whole{{0, 0}, {1280, 720}};
    const Box right = moved(whole, {1300, 0});
    const ActParts before{.canvas = whole.max, .parts = {{"lead/a", {.box = whole}}}};
    const ActParts now{.canvas = right.max,
                       .parts = {{"lead/a", {.box = right}}, {"late/a", {.box = whole}}}};
    lead.set_canvas(canvas_of(before.canvas, {whole}));
    lead.led()->set_parts({before});
    house.run(8s);
    Canvas wider = canvas_of(now.canvas, {whole, right});
    wider.origin = {-1300, 0};
    lead.set_canvas(wider);
    lead.led()->set_parts({now, before});
    const TestBox& follower = house.boxes[1];
    for (int k = 0; k < 600 && follower.last.canvas == before.canvas; ++k) {
        const std::string path = path_of_first(follower);
        const double place = *place_of(follower, path);
        house.run(20ms);
        const double way = follower.last.canvas == before.canvas ? 0 : 1300;
        CHECK(std::abs(place_of(follower, path).value_or(-1e6) - place - way) < 0.2 * speed);
    }
    CHECK(follower.last.canvas == now.canvas);
}

TEST_CASE("a finger moves a panning wall on all boxes, and they go on together") {
    SharedHouse house(panning(5));
    house.run(20s);
    TestBox& lead = house.boxes[0];
    TestBox& follower = house.boxes[1];
    const std::string path = path_of_first(lead);
    std::vector<double> places;
    for (int k = 0; k < 15; ++k) {
        touch(house, Gesture::Kind::drag, 12);
        house.run(33ms);
        places.push_back(place_of(lead, path).value());
        if (k < 5) continue;
        const double seen = place_of(follower, path).value();
        CHECK(std::find(places.end() - 4, places.end(), doctest::Approx(seen)) != places.end());
    }
    CHECK(places.back() > places.front() + 100);
    house.run(2s);  // the finger rests
    CHECK(place_of(follower, path).value() == doctest::Approx(places.back()));
    CHECK(lead.frames.back().content == follower.frames.back().content);
    touch(house, Gesture::Kind::drop, 0);
    house.run(1s);
    CHECK(place_of(follower, path).value() < places.back() - 0.8 * speed);
    CHECK(share_in_step(lead, follower, house.truth - 1s) >= 0.96);  // the last frame may be to come
    CHECK(follower.gaps == 0);
}

TEST_CASE("a notice takes the place of a panning wall on all boxes, and the wall comes back after it") {
    const SharedHouse::Options options = panning(8);
    SharedHouse house(options);
    house.run(20s);
    for (const bool is_notice : {true, false}) {
        house.boxes[0].show->set_catalogue(is_notice ? std::vector<MediaRecord>{photo("!NOW fire.jpg")}
                                                     : options.records);
        std::set<std::string> mixed;  // the boxes that fade from one to the other
        for (int k = 0; k < 60; ++k) {
            house.run(50ms);
            for (const TestBox& box : house.boxes)
                if (std::ranges::any_of(box.last.items, [](const DrawItem& item) {
                        return item.alpha > 0.3 && item.alpha < 0.7;
                    }))
                    mixed.insert(box.name);
        }
        CHECK(mixed.size() == house.boxes.size());
        for (const TestBox& box : house.boxes) {
            REQUIRE_FALSE(box.last.items.empty());
            for (const DrawItem& item : box.last.items)
                CHECK((box.playing.at(item.source).path == "!NOW fire.jpg") == is_notice);
            CHECK(box.gaps == 0);
        }
        CHECK(house.boxes[0].frames.back().content == house.boxes[1].frames.back().content);
    }
    CHECK(house.faults == 0);
}

TEST_CASE("a panning wall stands on all boxes while a visitor looks at a shot") {
    SharedHouse house(panning(6));
    house.run(20s);
    TestBox& lead = house.boxes[0];
    TestBox& follower = house.boxes[1];
    const std::optional<SeenShot> seen = lead.show->shot_at({640, 360});
    REQUIRE(seen);
    const Gesture tap{.kind = Gesture::Kind::tap,
                      .touch = 2,
                      .subject = seen->source,
                      .at = {640, 360},
                      .from = {640, 360}};
    lead.show->handle_gesture(tap);
    house.run(1500ms);
    const double view = follower.last.view.x;
    CHECK(lead.last.items.back().placement.scale > 1.01 * lead.last.items.front().placement.scale);
    CHECK(lead.frames.back().content == follower.frames.back().content);
    house.run(1s);
    CHECK(follower.last.view.x == doctest::Approx(view));
    lead.show->handle_gesture(tap);
    house.run(2s);
    CHECK(follower.last.view.x > view + 0.5 * speed);
    CHECK(share_in_step(lead, follower, house.truth - 1s) >= 0.96);  // the last frame may be to come
    CHECK(follower.gaps == 0);
}

TEST_CASE("a leader that comes back with a panning wall fades it in over the wall that was shown") {
    SharedHouse::Options options = panning(7);
    options.pan.reset();
    options.lay_out = side_by_side;
    SharedHouse house(options);
    house.run(8s);
    house.pan(panning(7).pan.value(), packed);
    house.run(12s);
    CHECK(house.boxes[1].gaps == 0);
    CHECK(share_in_step(house.boxes[0], house.boxes[1], house.truth - 2s) >= 0.96);
}
