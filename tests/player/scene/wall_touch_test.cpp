#include "player/scene/wall_touch.hpp"

#include "tests/player/scene/touched_house.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

using Kind = Contact::Kind;

/// The canvas point of a lifted shot that was at this place when a finger took it there.
bool is_about(const DrawItem& item, const PlacedShot& home, Vec2 from, Vec2 finger) {
    const Vec2 on_picture = (from - home.placement.offset) * (1 / home.placement.scale);
    return length(on_picture * item.placement.scale + item.placement.offset - finger) < 1e-6;
}

Box drawn_box(const DrawItem& item) {
    Box box = bounding_box(item.cell->parts[0]);
    for (const Polygon& part : item.cell->parts)
        box = united(box, bounding_box(part));
    return box;
}

}  // namespace

TEST_CASE("two hands drag two shots at once; each is under its finger in the very next frame") {
    TouchedHouse house;
    const std::vector<PlacedShot> before = house.wall;
    const Vec2 from[] = {centre_of(before[1]), centre_of(before[4])};
    const Vec2 to[] = {{500, 100}, {120, 260}};
    int dragged = 0;
    for (const int k : {0, 1})
        house.put(Kind::down, k, from[k]);
    for (int step = 1; step <= 40; ++step) {
        Vec2 at[2];
        for (const int k : {0, 1})
            house.put(Kind::move, k, at[k] = from[k] + (to[k] - from[k]) * (step / 40.0));
        const Frame frame = house.frame();
        if (frame.items.size() < 8) continue;  // a finger trembles before it drags
        ++dragged;
        CHECK(is_about(TouchedHouse::top_of(frame, 2), before[1], from[0], at[0]));
        CHECK(is_about(TouchedHouse::top_of(frame, 5), before[4], from[1], at[1]));
        CHECK(covered_by_others(frame, house.wall) < 1);
    }
    for (const int k : {0, 1})
        house.put(Kind::up, k);
    house.run(2s);
    CHECK(dragged > 20);
    CHECK_FALSE(house.touch.is_active());
    CHECK(length(centre_of(house.wall[1]) - to[0]) < 0.2 * length(packed_canvas));
    CHECK(length(centre_of(house.wall[4]) - to[1]) < 0.2 * length(packed_canvas));
    CHECK(house.placements()[1] != before[1].placement);
}

TEST_CASE(
    "a tapped shot is seen whole and as large as the screen, the rest dim; tapped again all is as it was") {
    TouchedHouse house;
    const std::vector<Placement> before = house.placements();
    house.tap(centre_of(house.wall[2]));
    Frame frame = house.run(1s);
    const DrawItem& large = TouchedHouse::top_of(frame, 3);
    CHECK(&large == &frame.items.back());
    CHECK(large.alpha == 1);
    const Box box = drawn_box(large);
    CHECK(length(box.min - Vec2{0, 0}) < 1e-6);  // the picture has the canvas' shape
    CHECK(length(box.max - packed_canvas) < 1e-6);
    for (std::size_t i = 0; i < 6; ++i)
        CHECK(frame.items[i].alpha == doctest::Approx(waiting_light));
    CHECK(house.touch.take_needs().requests.empty());  // asked for when it grew

    house.tap({30, 30});
    frame = house.run(1s);
    CHECK(frame.items.size() == 6);
    for (const DrawItem& item : frame.items)
        CHECK(item.alpha == 1);
    CHECK(house.placements() == before);
    CHECK_FALSE(house.touch.is_active());
}

TEST_CASE("a lifted shot leaves behind what lies apart from its cell, and its filler") {
    TouchedHouse house;
    Cell cell = *house.wall[1].cell;
    const Polygon apart = to_polygon({{600, 340}, {610, 350}});
    cell.parts.push_back(apart);
    cell.filler.push_back(apart);
    house.wall[1].cell = std::make_shared<const Cell>(cell);
    house.drag(0, centre_of(house.wall[1]), {320, 180});
    const Frame frame = house.frame();
    REQUIRE(frame.items.size() == 7);
    CHECK(frame.items.back().cell->parts.size() == 1);
    CHECK(frame.items.back().cell->filler.empty());
}

TEST_CASE("a tapped shot returns by itself after a while, or with a key") {
    for (const bool by_key : {false, true}) {
        TouchedHouse house;
        house.tap(centre_of(house.wall[0]));
        CHECK(house.run(9s).items.size() == 7);
        if (by_key) house.gestures.handle_input(KeyPress{.key = Key::back, .time = house.now});
        CHECK(house.run(by_key ? 500ms : 2s).items.size() == 6);
    }
}

TEST_CASE(
    "while another hand drags, a tap enlarges in place, and to the whole screen when the hand has gone") {
    TouchedHouse house;
    const std::vector<PlacedShot> before = house.wall;
    house.drag(0, centre_of(before[5]), centre_of(before[5]) + Vec2{20, 0});
    house.tap(centre_of(house.wall[0]));
    Frame frame = house.run(1s);
    CHECK(frame.items.size() == 7);  // the dragged one is lifted, the tapped one is not
    CHECK(house.wall[0].placement.scale > 1.1 * before[0].placement.scale);
    CHECK(covered_by_others(frame, house.wall) < 1);
    house.put(Kind::up, 0);
    frame = house.run(1500ms);
    REQUIRE(frame.items.size() == 7);
    CHECK(frame.items.back().source == 1);
    CHECK(drawn_box(frame.items.back()).width() == doctest::Approx(packed_canvas.x));
    house.tap({320, 180});
    house.run(1s);
    CHECK_FALSE(house.touch.is_active());
    CHECK(house.wall[0].placement.scale < 1.2 * before[0].placement.scale);
}

TEST_CASE("a shot is large while a finger rests on it, and is back in its place afterwards") {
    TouchedHouse house;
    const std::vector<Placement> before = house.placements();
    house.put(Kind::down, 0, centre_of(house.wall[3]));
    Frame frame = house.run(20s);
    REQUIRE(frame.items.size() == 7);
    CHECK(drawn_box(frame.items.back()).width() == doctest::Approx(0.62 * packed_canvas.x));
    house.put(Kind::up, 0);
    frame = house.run(1s);
    CHECK(frame.items.size() == 6);
    CHECK(house.placements() == before);
}

TEST_CASE("a film whose subject moves does not slide while it is seen whole, and gets there without a jump") {
    constexpr auto frame_time = 40ms;
    TouchedHouse house;
    house.put(Kind::down, 0, centre_of(house.wall[3]));
    double before = 1;
    for (int k = 0; k < 50; ++k) {
        const Frame frame = house.run(frame_time);
        const double share = frame.items.size() == 7 ? frame.items.back().slide_share : 1;
        CHECK(share <= before);
        CHECK(share > before - 0.4);
        before = share;
    }
    CHECK(before == 0);
    house.put(Kind::up, 0);
    const Frame frame = house.run(1s);
    CHECK(std::ranges::all_of(frame.items, [](const DrawItem& item) { return item.slide_share == 1; }));
}

TEST_CASE("a contact that is lost, or rests too long, leaves all as it was") {
    for (const bool is_cancelled : {true, false}) {
        TouchedHouse house;
        const std::vector<Placement> before = house.placements();
        house.drag(0, centre_of(house.wall[1]), {600, 300});
        if (is_cancelled) house.put(Kind::cancel, 0);
        house.run(is_cancelled ? 2s : 62s);
        CHECK_FALSE(house.touch.is_active());
        CHECK(house.placements() == before);
    }
}

TEST_CASE("a shot that is flicked out is offered in its place for a moment; a tap there has it back") {
    for (const int way : {0, 1, 2}) {
        CAPTURE(way);
        TouchedHouse house;
        const std::vector<Placement> before = house.placements();
        const Vec2 at = centre_of(house.wall[4]);
        house.flick_right(at);
        Frame frame = house.run(2s);
        CHECK(house.placements() == before);
        CHECK(frame.items[4].alpha == doctest::Approx(waiting_light));
        CHECK(house.dismissed.empty());
        if (way == 0) house.tap(at);
        if (way == 1) house.gestures.handle_input(KeyPress{.key = Key::undo, .time = house.now});
        frame = house.run(3s);
        CHECK(house.dismissed.contains(5) == (way == 2));
        CHECK(house.touch.is_active() == false);
        CHECK((frame.items[4].alpha == 1) == (way != 2));
        CHECK(frame.items.size() == (way == 2 ? 6 : 6));
    }
}

TEST_CASE("behind the only shot of a wall, or all of two, the idle picture stands while hands have them") {
    for (const int count : {1, 2}) {
        CAPTURE(count);
        TouchedHouse house(count);
        std::vector<Vec2> from;
        for (int k = 0; k < count; ++k)
            house.put(Kind::down, k, from.emplace_back(centre_of(house.wall[static_cast<std::size_t>(k)])));
        double last = 1;  // opacity of the wall below
        int risen = 0, bare = 0;
        const auto look = [&] {
            const Frame frame = house.frame();
            double below = 0;
            for (int k = 0; k < count; ++k)
                below = std::max(below, frame.items[static_cast<std::size_t>(k)].alpha);
            CHECK((below >= 1 || frame.idle == 1));
            CHECK(std::abs(below - last) < 0.35);
            if (below > last + 1e-9) ++risen;
            if (below < 1e-9) ++bare;
            last = below;
        };
        for (int step = 1; step <= 40; ++step) {
            for (int k = 0; k < count; ++k)
                house.put(Kind::move, k, from[static_cast<std::size_t>(k)] + Vec2{4.0 * step, 0});
            look();
        }
        CHECK(risen == 0);
        CHECK(bare > 20);
        for (int k = 0; k < count; ++k)
            house.put(Kind::up, k);
        for (int step = 0; step < 80; ++step)
            look();
        CHECK(last == 1);
    }
}

TEST_CASE("a notice is not flicked out: it returns to its place") {
    TouchedHouse house;
    house.wall[4].shot.key.path = "!NOW 5min fire/a.jpg";
    const std::vector<Placement> before = house.placements();
    house.flick_right(centre_of(house.wall[4]));
    const Frame frame = house.run(8s);
    CHECK(house.dismissed.empty());
    CHECK_FALSE(house.touch.is_active());
    CHECK(frame.items[4].alpha == 1);
    CHECK(house.placements() == before);
}

TEST_CASE("a shot that is dropped beside the canvas returns to its place") {
    TouchedHouse house;
    const std::vector<Placement> before = house.placements();
    house.drag(0, centre_of(house.wall[1]), {-40, 100});
    house.run(500ms);
    house.put(Kind::up, 0);
    house.run(2s);
    CHECK(house.placements() == before);
}

TEST_CASE("a second finger on a shot in another hand does not take it; the shot of a hand is no other's") {
    TouchedHouse house;
    house.drag(0, centre_of(house.wall[1]), {320, 180});
    const PlacedShot* under = house.touch.shot_at({320, 180}, house.touched());
    REQUIRE(under != nullptr);
    CHECK(under->shot.source == 2);
    house.put(Kind::down, 1, {320, 180});  // with the first finger it makes a pinch
    house.frame();
    CHECK(house.recognised.size() == 1);
    CHECK(house.recognised[0].kind == Gesture::Kind::drop);
}

TEST_CASE("shots of a calm wall are not dragged, and fade in large") {
    TouchedHouse house;
    house.touch = WallTouch({.idle = 10s, .is_calm = true});
    const std::vector<Placement> before = house.placements();
    house.drag(0, centre_of(house.wall[1]), {600, 300});
    CHECK(house.frame().items.size() == 6);
    house.put(Kind::up, 0);
    house.tap(centre_of(house.wall[2]));
    const Frame first = house.frame();
    CHECK(drawn_box(TouchedHouse::top_of(house.frame(), 3)).width() == doctest::Approx(packed_canvas.x));
    CHECK(house.run(1s).items.back().alpha == 1);
    CHECK(house.placements() == before);
}

TEST_CASE("a wall that is left alone shows that it can be touched, one shot after the other") {
    TouchedHouse house;
    house.touch = WallTouch({.idle = 10s, .hint = 60s});
    const std::vector<Placement> before = house.placements();
    std::set<SourceId> beckoning;
    for (int k = 0; k < 40 * 59; ++k)
        REQUIRE(house.frame().items.size() == 6);
    for (int k = 0; k < 40 * 42; ++k) {
        const Frame frame = house.frame();
        if (frame.items.size() == 6) continue;
        REQUIRE(frame.items.size() == 7);
        const SourceId source = frame.items.back().source;
        beckoning.insert(source);
        CHECK(frame.items.back().placement == before[source - 1]);
        CHECK(TouchedHouse::below_of(frame, source == 1 ? 2 : 1).alpha >= 0.6);
    }
    CHECK(beckoning == std::set<SourceId>{1, 2, 3, 4, 5});
    CHECK(house.placements() == before);

    house.tap(centre_of(house.wall[2]));
    house.run(2s);
    house.tap(centre_of(house.wall[2]));
    for (int k = 0; k < 40 * 57; ++k)
        if (k > 80)
            REQUIRE(house.frame().items.size() == 6);
        else
            house.frame();
}

TEST_CASE("on a canvas of several outputs a tapped shot becomes as large as the one that was touched") {
    TouchedHouse house;
    const Box left{{0, 0}, {packed_canvas.x / 2 - 10, packed_canvas.y}};
    const Box right{{packed_canvas.x / 2 + 10, 0}, packed_canvas};
    house.canvas = canvas_of(packed_canvas, {left, right});
    for (const Box& output : {left, right}) {
        const auto at = std::ranges::find_if(house.wall, [&](const PlacedShot& placed) {
            const Vec2 centre = centre_of(placed);
            return centre.x > output.min.x && centre.x < output.max.x;
        });
        REQUIRE(at != house.wall.end());
        house.tap(centre_of(*at));
        const Frame frame = house.run(2s);
        const DrawItem& large = frame.items.back();
        CHECK(large.source == at->shot.source);
        const Box shown{large.placement.offset,
                        large.placement.offset + large.picture * large.placement.scale};
        CHECK(intersection(shown, {output.min - Vec2{0.1, 0.1}, output.max + Vec2{0.1, 0.1}}) == shown);
        CHECK(std::max(shown.width() / output.width(), shown.height() / output.height()) ==
              doctest::Approx(1));
        house.tap(output.centre());
        house.run(2s);
    }
}
