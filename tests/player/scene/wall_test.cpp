#include "player/scene/wall.hpp"

#include "tests/player/scene/scene_media.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

/// The player around a wall, without its files and screen: plans at once, sources ready when told.
struct House {
    Wall wall;
    std::chrono::nanoseconds now = 0s;
    bool plans = true;
    bool readies = true;
    bool is_dim = false;  // the only shot is offered in its place
    std::map<SourceId, ShotRequest> playing{};
    std::vector<WallPlan> planned{};
    int requests = 0;

    static Layout layout_of(const WallPlan& plan) {
        Layout layout{.canvas = plan.canvas, .generation = plan.generation, .is_final = true};
        for (std::size_t i = 0; i < plan.items.size(); ++i) {
            layout.placements.push_back({.scale = 0.5, .offset = {100.0 * static_cast<double>(i), 0}});
        }
        return layout;
    }

    void plan(const WallPlan& wanted) {
        if (!wanted.way) return wall.set_layout(layout_of(wanted));
        Layout layout{.canvas = wanted.canvas, .generation = wanted.generation, .is_final = true};
        layout.way = std::make_shared<const WallWay>(way_to(*wanted.way));
        wall.set_layout(layout);
    }

    /// Lays the last plan out in a row, so large.
    void give(double scale) {
        Layout layout = layout_of(planned.back());
        for (std::size_t i = 0; i < layout.placements.size(); ++i)
            layout.placements[i] = {scale, {scale * 200.0 * static_cast<double>(i), 0}};
        wall.set_layout(layout);
    }

    /// One refresh; checks what must hold in every one.
    WallStep step() {
        WallStep step = wall.step(now);
        for (const ShotRequest& request : step.requests) {
            playing[request.source] = request;
            ++requests;
            if (readies) wall.source_ready(request.source);
        }
        for (const SourceId source : step.retired) {
            REQUIRE(playing.erase(source) == 1);
        }
        for (const DrawItem& item : step.frame.items)
            REQUIRE(playing.contains(item.source));
        const bool is_covered =
            step.frame.idle == 1 || is_dim ||
            std::ranges::any_of(step.frame.items, [](const DrawItem& item) { return item.alpha == 1; });
        REQUIRE(is_covered);
        if (step.plan && !step.plan->way) planned.push_back(*step.plan);
        if (step.plan && plans) plan(*step.plan);
        now += 50ms;
        return step;
    }

    WallStep run(std::chrono::nanoseconds duration) {
        WallStep last = step();
        for (const auto end = now + duration; now < end;)
            last = step();
        return last;
    }
};

House house(const std::vector<MediaRecord>& records, int slots = 3) {
    House house{.wall = Wall({1280, 720}, {.slots = {.count = slots, .order = ShotOrder::name}})};
    house.wall.set_catalogue(records);
    return house;
}

std::vector<std::string> shown_paths(const House& house) {
    std::vector<std::string> paths;
    for (const PlacedShot& placed : house.wall.shown())
        paths.push_back(placed.shot.key.path);
    return paths;
}

}  // namespace

TEST_CASE("an empty catalogue shows the idle picture and asks for nothing") {
    House house = ::house({});
    const WallStep last = house.run(5s);
    CHECK(last.frame.idle == 1);
    CHECK(house.planned.empty());
    CHECK(house.requests == 0);
}

TEST_CASE("a wall is planned, asked for, faded in over the idle picture, and then stands") {
    House house = ::house({photo("a"), film("b", 1), photo("c"), photo("d")});
    WallStep step = house.step();
    CHECK(step.plan->items.size() == 3);
    CHECK(step.requests.empty());
    step = house.step();
    CHECK(step.requests.size() == 3);
    CHECK(step.requests[1].path == "b");
    CHECK(step.requests[1].kind == MediaKind::film);
    CHECK(step.requests[1].shot.end == 4s);
    CHECK(step.requests[1].width == 320);
    CHECK(step.requests[1].height == 180);
    CHECK(step.frame.idle == 1);
    house.step();
    step = house.run(300ms);
    CHECK(step.frame.idle == 1);
    CHECK(step.frame.items.size() == 3);
    CHECK(step.frame.items[0].alpha > 0);
    CHECK(step.frame.items[0].alpha < 1);
    step = house.run(1s);
    CHECK(step.frame.idle == 0);
    CHECK(step.frame.items.size() == 3);
    CHECK(step.frame.items[0].alpha == 1);
    CHECK(house.planned.size() == 1);
    CHECK(house.requests == 3);
}

TEST_CASE("the shots of the first wall fade in over the idle picture, each when it is ready") {
    House house = ::house({photo("a"), photo("b"), photo("c")});
    house.readies = false;
    WallStep step = house.run(3s);
    CHECK(step.frame.items.empty());
    const std::map<SourceId, ShotRequest> asked = house.playing;
    REQUIRE(asked.size() == 3);
    const SourceId first = asked.begin()->first;
    house.wall.source_ready(first);
    step = house.run(400ms);
    REQUIRE(step.frame.items.size() == 1);
    CHECK(step.frame.items[0].source == first);
    CHECK(step.frame.items[0].alpha == doctest::Approx(0.5));
    CHECK(step.frame.idle == 1);
    house.wall.source_ready(asked.rbegin()->first);
    step = house.run(400ms);
    REQUIRE(step.frame.items.size() == 2);
    CHECK(step.frame.items[0].alpha == 1);
    CHECK(step.frame.items[1].alpha == doctest::Approx(0.5));
    CHECK(step.frame.idle == 1);
    house.wall.source_failed(std::next(asked.begin())->first, house.now);
    CHECK(house.run(3s).frame.idle == 0);
    CHECK(house.wall.count() == 2);
}

TEST_CASE("what of the first wall is not ready in time does not keep it from going on") {
    House house = ::house({photo("a"), photo("b"), photo("c")}, 2);
    house.readies = false;
    house.run(1s);
    house.wall.source_ready(house.playing.begin()->first);
    house.run(5s);
    CHECK(house.wall.count() == 0);
    house.readies = true;
    house.run(8s);
    CHECK(shown_paths(house) == std::vector<std::string>{"a", "c"});
}

TEST_CASE("a later change does not fade in before all its sources are ready") {
    House house = ::house({photo("a"), photo("b")});
    house.run(2s);
    house.readies = false;
    house.wall.set_catalogue(std::vector{photo("a"), photo("b"), photo("c")});
    CHECK(house.run(3s).frame.items.size() == 2);
    house.wall.source_ready(house.playing.rbegin()->first);
    CHECK(house.run(2s).frame.items.size() == 3);
}

TEST_CASE("the first wall's sources get ready while its layout is made, and it waits for the last one") {
    House house = ::house({photo("a"), photo("b")});
    house.plans = false;
    house.step();
    const auto give = [&](double scale, bool is_final) {
        Layout layout = House::layout_of(house.planned.at(0));
        for (Placement& placement : layout.placements)
            placement.scale = scale;
        layout.is_final = is_final;
        house.wall.set_layout(layout);
    };
    give(0.4, false);
    house.step();
    CHECK(house.requests == 2);
    give(0.45, false);
    CHECK(house.run(2s).frame.items.empty());
    CHECK(house.requests == 2);
    give(0.5, true);
    const WallStep step = house.run(2s);
    CHECK(house.requests == 4);
    CHECK(house.playing.begin()->second.width == 320);
    REQUIRE(step.frame.items.size() == 2);
    CHECK(step.frame.items[0].placement.scale == 0.5);
}

TEST_CASE("a change takes only the last layout") {
    House house = ::house({photo("a"), photo("b")});
    house.run(2s);
    house.plans = false;
    house.wall.set_catalogue(std::vector{photo("a"), photo("b"), photo("c")});
    house.step();
    Layout layout = House::layout_of(house.planned.back());
    layout.is_final = false;
    house.wall.set_layout(layout);
    house.run(2s);
    CHECK(house.requests == 2);
    house.plan(house.planned.back());
    house.run(2s);
    CHECK(house.wall.count() == 3);
}

TEST_CASE("a shot plays from the moment it appears") {
    House house = ::house({film("f", 1, 4s)}, 1);
    house.readies = false;
    house.run(3s);
    house.wall.source_ready(house.playing.begin()->first);
    const auto appears = house.now;
    house.step();
    house.run(1s);
    const WallStep step = house.step();
    CHECK(step.frame.items.at(0).local == step.frame.time - appears);
}

TEST_CASE("a source that does not get ready in time gives way to another") {
    House house = ::house({photo("a"), photo("b"), photo("c")}, 2);
    house.readies = false;
    house.run(1s);
    house.wall.source_ready(house.playing.begin()->first);  // file a
    house.readies = true;  // sources that are asked for from now on are ready
    CHECK(house.run(12s).frame.items.size() == 2);
    CHECK(shown_paths(house) == std::vector<std::string>{"a", "c"});
    CHECK(house.playing.size() == 2);
}

TEST_CASE("a wall without a picture waits a minute for its first one, and as long for the others as ever") {
    House house = ::house({photo("a"), photo("b"), photo("c")}, 2);
    house.readies = false;
    house.run(50s);
    REQUIRE(house.requests == 2);  // nothing is given up
    house.wall.source_ready(house.playing.begin()->first);
    house.run(8s);
    CHECK(house.requests == 2);
    house.wall.source_ready(house.playing.rbegin()->first);
    house.run(3s);
    CHECK(shown_paths(house) == std::vector<std::string>{"a", "b"});
}

TEST_CASE("after a minute without a picture others are asked for") {
    House house = ::house({photo("a"), photo("b"), photo("c")}, 2);
    house.readies = false;
    house.run(59s);
    REQUIRE(house.requests == 2);
    house.run(3s);
    CHECK(house.requests > 2);
}

TEST_CASE("a change of turn keeps the others playing and starts the new one in the old one's place") {
    House house = ::house({photo("a"), photo("b"), photo("c"), photo("d")});
    house.run(2s);
    const std::set<SourceId> before{house.playing.begin()->first, std::next(house.playing.begin())->first,
                                    house.playing.rbegin()->first};
    while (house.planned.size() < 2)
        house.step();
    const WallPlan& plan = house.planned.back();
    CHECK(plan.items[1].previous == Placement{.scale = 0.5, .offset = {100, 0}});  // stays
    CHECK_FALSE(plan.items[0].previous);
    REQUIRE(plan.items[0].seat);
    CHECK(plan.items[0].seat->area == doctest::Approx(0.25 * area(plan.items[1].item.region)));
    house.run(5s);
    CHECK(shown_paths(house) == std::vector<std::string>{"d", "b", "c"});
    CHECK(house.playing.size() <= 4);  // the next one gets ready
    CHECK_FALSE(house.playing.contains(*before.begin()));
    for (auto source = std::next(before.begin()); source != before.end(); ++source) {
        CHECK(house.playing.contains(*source));
    }
}

TEST_CASE(
    "a shot that stays where it is has room for its caption all the time, the others while the wall stands") {
    House house = ::house({photo("a"), photo("b"), photo("c"), photo("d")});
    while (house.wall.shown().size() < 3)
        house.step();
    int changing = 0;
    while (shown_paths(house).front() == "a") {
        const WallStep step = house.step();
        if (shown_paths(house).front() != "a") break;
        std::set<std::string> paths;
        for (const CaptionRoom& room : step.frame.captions)
            paths.insert(room.path);
        CHECK(paths.contains("b"));
        CHECK(paths.contains("c"));
        CHECK(paths.contains("a") != is_in_change(house.wall));
        if (is_in_change(house.wall)) ++changing;
    }
    CHECK(changing > 3);
}

TEST_CASE("the newcomer is given the seat of the shot before it: the middle and the area of its region") {
    House house = ::house({photo("a"), photo("b"), photo("c")}, 2);
    while (house.planned.size() < 2)
        house.step();
    const PlanItem& newcomer = house.planned.back().items[0];
    CHECK_FALSE(newcomer.previous);
    REQUIRE(newcomer.seat);
    CHECK(newcomer.seat->centre == Vec2{320 * 0.5, 180 * 0.5});
    CHECK(newcomer.seat->area == doctest::Approx(160 * 120 * 0.25));
}

TEST_CASE("on a canvas of more displays than files each display shows one, until further files come") {
    const Canvas canvas = canvas_of({1280, 720}, {{{0, 0}, {630, 720}}, {{650, 0}, {1280, 720}}});
    House house{.wall = Wall(canvas, {.slots = {.count = 3, .order = ShotOrder::name}})};
    house.wall.set_catalogue(std::vector{photo("a")});
    house.run(2s);
    CHECK(shown_paths(house) == std::vector<std::string>{"a", "a"});
    CHECK(house.playing.size() == 2);
    house.wall.set_catalogue(std::vector{photo("a"), photo("b")});
    house.run(2s);
    CHECK(shown_paths(house) == std::vector<std::string>{"a", "b"});
    REQUIRE(house.planned.back().items[1].seat);  // the place of the copy
    CHECK(house.planned.back().items[1].seat->centre == Vec2{320 * 0.5 + 100, 180 * 0.5});
    house.wall.set_catalogue(std::vector{photo("b")});
    house.run(2s);
    CHECK(shown_paths(house) == std::vector<std::string>{"b", "b"});
    house.wall.set_canvas({630, 720});  // a display is gone
    house.run(2s);
    CHECK(shown_paths(house) == std::vector<std::string>{"b"});
    CHECK(house.playing.size() == 1);
}

TEST_CASE("a display that comes leaves the others as they are until the new wall fades in") {
    Canvas right = canvas_of({640, 720}, {{{0, 0}, {640, 720}}});
    right.origin = {700, 0};
    const Canvas both = canvas_of({1340, 720}, {{{0, 0}, {640, 720}}, {{700, 0}, {1340, 720}}});
    House house{.wall = Wall(right, {.slots = {.count = 2, .order = ShotOrder::name}})};
    house.wall.set_catalogue(photos(2));
    const Frame before = house.run(2s).frame;
    house.wall.set_canvas(both);
    WallStep step = house.step();
    while (step.frame.canvas == Vec2(right))
        step = house.step();
    REQUIRE(step.frame.items.size() >= 2);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(step.frame.items[i].source == before.items[i].source);
        CHECK(step.frame.items[i].placement.scale == before.items[i].placement.scale);
        CHECK(step.frame.items[i].placement.offset == before.items[i].placement.offset + Vec2{700, 0});
    }
    CHECK(step.frame.idle == 1);  // on the display that has come
    CHECK(house.run(2s).frame.idle == 0);
}

TEST_CASE("a picture that stands on two displays and is flicked from one stays on the other") {
    const Canvas canvas = canvas_of({1280, 720}, {{{0, 0}, {630, 720}}, {{650, 0}, {1280, 720}}});
    House house{.wall = Wall(canvas, {.slots = {.count = 1, .order = ShotOrder::name}})};
    house.wall.set_catalogue(std::vector{photo("a")});
    house.run(2s);
    REQUIRE(house.wall.shown().size() == 2);
    const SourceId first = house.wall.shown()[0].shot.source;
    const SourceId second = house.wall.shown()[1].shot.source;
    const Vec2 from{160, 90};
    Gesture gesture{.kind = Gesture::Kind::drag, .touch = 1, .subject = first, .at = from, .from = from};
    house.wall.handle_gesture(gesture);
    house.run(100ms);
    gesture.kind = Gesture::Kind::flick;
    gesture.velocity = {-9000, 0};
    house.wall.handle_gesture(gesture);
    house.run(8s);  // after the time in which it may be had back
    REQUIRE(house.wall.shown().size() == 1);
    CHECK(house.wall.shown()[0].shot.source == second);
    house.run(60s);
    CHECK(shown_paths(house) == std::vector<std::string>{"a", "a"});
}

TEST_CASE("a film on two displays is in step, and fails as one") {
    const Canvas canvas = canvas_of({1280, 720}, {{{0, 0}, {630, 720}}, {{650, 0}, {1280, 720}}});
    House house{.wall = Wall(canvas, {.slots = {.count = 1, .order = ShotOrder::name}})};
    house.wall.set_catalogue(std::vector{film("a", 1), film("b", 1)});
    house.readies = false;
    house.run(1s);
    REQUIRE(house.playing.size() == 2);
    house.wall.source_ready(house.playing.begin()->first);
    CHECK(house.run(1s).frame.items.empty());
    house.wall.source_ready(house.playing.rbegin()->first);
    const WallStep step = house.run(1s);
    REQUIRE(step.frame.items.size() == 2);
    CHECK(step.frame.items[0].local == step.frame.items[1].local);
    house.readies = true;
    house.wall.source_failed(house.playing.rbegin()->first, house.now);  // the copy's
    house.run(2s);
    CHECK(shown_paths(house) == std::vector<std::string>{"b", "b"});
}

TEST_CASE("a deleted file leaves with the next transition, the last one to the idle picture") {
    House house = ::house({photo("a"), photo("b")});
    house.run(2s);
    house.wall.set_catalogue(std::vector{photo("b")});
    house.run(1s);
    CHECK(shown_paths(house) == std::vector<std::string>{"b"});
    CHECK(house.playing.size() == 1);
    house.wall.set_catalogue({});
    const WallStep step = house.run(1s);
    CHECK(step.frame.items.empty());
    CHECK(step.frame.idle == 1);
    CHECK(house.playing.empty());
}

TEST_CASE("a notice is there a quarter of a second after its picture is ready") {
    House house = ::house({photo("a"), photo("b"), photo("c")});
    house.run(3s);
    REQUIRE(house.wall.shown().size() == 3);
    house.wall.set_catalogue(std::vector{photo("!NOW fire.jpg")});
    std::chrono::nanoseconds began = 0s;
    while (shown_paths(house) != std::vector<std::string>{"!NOW fire.jpg"} && house.now < 10s) {
        if (began == 0s && house.playing.size() == 4) began = house.now;
        house.step();
    }
    CHECK(house.now - began <= 400ms);  // with two refreshes of 50 ms before the first picture

    house.wall.set_catalogue(std::vector{photo("a"), photo("b"), photo("c")});
    const auto over = house.now;
    while (shown_paths(house).size() != 3 && house.now < over + 10s)
        house.step();
    CHECK(house.now - over >= 800ms);  // the wall comes back as any wall does
}

TEST_CASE("what is wanted meanwhile replaces a change that has not begun to fade, its sources retire") {
    House house = ::house({photo("a"), photo("b")});
    house.readies = false;
    house.run(1s);
    house.wall.set_catalogue(std::vector{photo("b"), photo("c")});
    house.readies = true;
    house.run(2s);
    CHECK(shown_paths(house) == std::vector<std::string>{"c", "b"});
    CHECK(house.playing.size() == 2);
}

TEST_CASE("a change that comes during a fade waits for its end") {
    House house = ::house({photo("a")});
    house.step();
    house.step();
    CHECK(house.run(200ms).frame.items.at(0).alpha < 1);
    house.wall.set_catalogue({});
    const WallStep step = house.run(100ms);
    REQUIRE(step.frame.items.size() == 1);
    CHECK(step.frame.items[0].alpha < 1);
    CHECK(house.run(2s).frame.items.empty());
}

TEST_CASE("a source that fails while it plays stays as it is until another has taken its place") {
    House house = ::house({photo("a"), photo("b"), photo("c")}, 2);
    house.run(2s);
    house.readies = false;
    house.wall.source_failed(house.playing.begin()->first, house.now);
    CHECK(house.run(1s).frame.items.size() == 2);
    CHECK(shown_paths(house) == std::vector<std::string>{"a", "b"});
    for (const auto& [source, request] : house.playing)
        house.wall.source_ready(source);
    house.run(1s);
    CHECK(shown_paths(house) == std::vector<std::string>{"c", "b"});
}

TEST_CASE("a file whose source has failed is avoided for a minute") {
    House house = ::house({photo("a"), photo("b"), photo("c")}, 2);
    house.run(2s);
    CHECK(house.wall.avoided_files().empty());
    house.wall.source_failed(house.playing.begin()->first, house.now);
    CHECK(house.wall.avoided_files() == std::set<std::string>{"a"});
    house.run(50s);
    CHECK(house.wall.avoided_files() == std::set<std::string>{"a"});
    house.run(15s);
    CHECK(house.wall.avoided_files().empty());
}

TEST_CASE("an outdated layout is ignored") {
    House house = ::house({photo("a")});
    house.plans = false;
    house.step();
    house.wall.set_catalogue(std::vector{photo("a"), photo("b")});
    house.step();
    CHECK(house.planned.size() == 2);
    house.plan(house.planned[0]);
    CHECK(house.step().requests.empty());
    house.plan(house.planned[1]);
    CHECK(house.step().requests.size() == 2);
}

TEST_CASE("another canvas lays the same shots out anew without restarting them") {
    House house = ::house({photo("a"), photo("b")});
    house.run(2s);
    const auto before = house.playing;
    house.wall.set_canvas({720, 1280});
    const WallStep step = house.run(2s);
    CHECK(house.planned.back().canvas == Vec2{720, 1280});
    CHECK(step.frame.canvas == Vec2{720, 1280});
    CHECK(house.playing.begin()->first == before.begin()->first);
    CHECK(house.planned.size() == 2);
}

TEST_CASE(
    "until a wall is laid out for another canvas it is shown whole on its own, then the new one fades in") {
    House house = ::house({photo("a"), photo("b")});
    house.run(2s);
    house.plans = false;
    house.wall.set_canvas({720, 1280});

    WallStep step = house.run(1s);
    CHECK(step.frame.canvas == Vec2{1280, 720});
    CHECK(step.frame.items.size() == 2);

    house.plan(house.planned.back());
    step = house.step();
    CHECK(step.frame.canvas == Vec2{720, 1280});
    REQUIRE(step.frame.items.size() >= 2);
    CHECK(step.frame.items[0].alpha == 1);
    CHECK(step.frame.items[0].placement.scale == doctest::Approx(0.5 * 720 / 1280));
    CHECK(step.frame.items[0].placement.offset.y == doctest::Approx((1280 - 720 * 720.0 / 1280) / 2));
    step = house.run(1s);
    CHECK(step.frame.canvas == Vec2{720, 1280});
    CHECK(step.frame.items.size() == 2);
    CHECK(step.frame.items[0].placement.scale == 0.5);
}

TEST_CASE("a shot that a finger holds goes with it, and nothing takes its turn meanwhile") {
    House house = ::house({photo("a"), photo("b"), photo("c"), photo("d")});
    house.run(2s);
    const SourceId held = house.wall.shown()[2].shot.source;
    const Vec2 from{360, 90};  // the middle of the third region
    for (int x = 370; x <= 1000; x += 10) {
        const Vec2 at{static_cast<double>(x), 90.0 + (x - 360) / 4.0};
        house.wall.handle_gesture({.kind = Gesture::Kind::drag,
                                   .touch = 1,
                                   .subject = held,
                                   .at = at,
                                   .from = from,
                                   .moved = {10, 2.5}});
        const WallStep step = house.step();
        CHECK(step.frame.items.size() >= 3);
    }
    house.run(60s);
    REQUIRE(house.wall.shown()[2].shot.source == held);
    const PlacedShot& placed = house.wall.shown()[2];
    CHECK(length(seat_of(placed.shot.item, placed.placement).centre - Vec2{1000, 250}) < 10);
    CHECK(house.planned.size() == 1);
    CHECK(house.playing.size() == 3);
    house.wall.handle_gesture(
        {.kind = Gesture::Kind::drop, .touch = 1, .subject = held, .at = {1000, 250}, .from = from});
    house.run(5s);
    CHECK(house.planned.size() > 1);
}

namespace {

/// The files of shots in the order of the slots, each with its region's area.
std::map<std::string, double> areas(const House& house) {
    std::map<std::string, double> areas;
    for (const PlacedShot& placed : house.wall.shown())
        areas[placed.shot.key.path] = seat_of(placed.shot.item, placed.placement).area;
    return areas;
}

constexpr Vec2 on_second{260, 90};  // the middle of the second region

Gesture on_second_shot(const House& house, Gesture::Kind kind) {
    return {.kind = kind,
            .touch = 1,
            .subject = house.wall.shot_at(on_second)->source,
            .at = on_second,
            .from = on_second};
}

}  // namespace

TEST_CASE("a shot that is tapped is as large as the screen for a while, and then all is as it was") {
    House house = ::house({photo("a"), photo("b"), photo("c")});
    house.run(2s);
    const auto before = areas(house);
    const SourceId second = house.wall.shown()[1].shot.source;
    const int usual = house.playing.at(second).width;
    for (const bool is_tapped_again : {false, true}) {
        house.wall.handle_gesture({.kind = Gesture::Kind::tap, .subject = second, .at = on_second});
        WallStep step = house.run(3s);
        REQUIRE(step.frame.items.size() == 4);
        CHECK(step.frame.items.back().placement.scale == 2);  // the picture has half the canvas' size
        CHECK(house.playing.at(second).width > usual);
        CHECK(house.wall.shot_at({20, 20})->source == second);
        if (is_tapped_again)
            house.wall.handle_gesture({.kind = Gesture::Kind::tap, .subject = second, .at = on_second});
        step = house.run(is_tapped_again ? 1s : 25s);
        CHECK((step.frame.items.size() == 3) == is_tapped_again);
        if (!is_tapped_again) step = house.run(4s);
        CHECK(step.frame.items.size() == 3);
        CHECK(areas(house) == before);
        CHECK(house.playing.at(second).width == usual);
    }
}

TEST_CASE("the film of a tapped Live Photo plays once above it, once that is as large as the screen") {
    MediaRecord moving = photo("b");
    Shot shot = film("x", 1, 3s).shots[0];
    shot.stored = StoredShot{.file = "0123/clip.mp4", .width = 64, .height = 36};
    moving.film = InnerFilm{.shot = shot, .width = 1920, .height = 1080};
    House house = ::house({photo("a"), moving, photo("c")});
    house.run(8s);  // its film has played
    const auto shown = house.wall.shown();
    const auto found =
        std::ranges::find(shown, "b", [](const PlacedShot& placed) { return placed.shot.key.path; });
    REQUIRE(found != shown.end());
    REQUIRE(found->shot.kind == MediaKind::photo);
    const SourceId photo_source = found->shot.source;
    const Vec2 place = seat_of(found->shot.item, found->placement).centre;
    for (const bool returns_early : {false, true}) {
        house.wall.handle_gesture({.kind = Gesture::Kind::tap, .subject = photo_source, .at = place});
        WallStep step = house.run(300ms);
        CHECK(step.frame.items.back().source == photo_source);  // it grows
        step = house.run(1200ms);
        const DrawItem& above = step.frame.items.back();
        CHECK(above.source != photo_source);
        CHECK(above.alpha == 1);
        CHECK(above.local > 500ms);
        CHECK(above.slide_share == 0);
        CHECK(above.placement.scale == doctest::Approx(1280.0 / 1920));
        CHECK(house.playing.at(above.source).kind == MediaKind::film);
        if (returns_early)
            house.wall.handle_gesture({.kind = Gesture::Kind::tap, .subject = photo_source, .at = place});
        step = house.run(returns_early ? 1s : 3s);
        CHECK(house.playing.size() == 3);
        CHECK((step.frame.items.size() == 3) == returns_early);
        CHECK(step.frame.items.back().source <= photo_source);
        if (returns_early) continue;
        house.wall.handle_gesture({.kind = Gesture::Kind::tap, .subject = photo_source, .at = place});
        house.run(2s);
    }
}

TEST_CASE("a shot that is held is large until it is let go, however long") {
    House house = ::house({photo("a"), photo("b"), photo("c")});
    house.run(2s);
    const auto before = areas(house);
    const Gesture hold = on_second_shot(house, Gesture::Kind::hold);
    house.wall.handle_gesture(hold);
    CHECK(house.run(100s).frame.items.size() == 4);
    Gesture release = hold;
    release.kind = Gesture::Kind::release;
    house.wall.handle_gesture(release);
    CHECK(house.run(1s).frame.items.size() == 3);
    CHECK(areas(house) == before);
}

namespace {

/// Drags the second shot a little, and lets go of it at this speed.
void flick_second(House& house, Vec2 velocity) {
    Gesture gesture = on_second_shot(house, Gesture::Kind::drag);
    gesture.moved = {1, 0};
    house.wall.handle_gesture(gesture);
    gesture.kind = Gesture::Kind::flick;
    gesture.velocity = velocity;
    house.wall.handle_gesture(gesture);
}

}  // namespace

TEST_CASE("a shot that is flicked out of the canvas leaves, and the next one comes to its place") {
    House house = ::house({photo("a"), photo("b"), photo("c"), photo("d")});
    house.run(2s);
    flick_second(house, {0, -900});
    house.run(3s);
    CHECK(shown_paths(house) == std::vector<std::string>{"a", "b", "c"});  // it may still be undone
    house.run(4s);
    CHECK(shown_paths(house) == std::vector<std::string>{"a", "d", "c"});
    REQUIRE(house.planned.size() >= 2);
    REQUIRE(house.planned[1].items[1].seat);
    CHECK(length(house.planned[1].items[1].seat->centre - on_second) < 1e-6);
}

TEST_CASE("a shot that is flicked out does not become bright again as the next one comes") {
    for (const bool has_more : {true, false}) {
        CAPTURE(has_more);
        House house = has_more ? ::house({photo("a"), photo("b"), photo("c"), photo("d")})
                               : ::house({photo("a"), photo("b"), photo("c")});
        const SourceId second = house.run(2s).frame.items[1].source;
        flick_second(house, {0, -900});
        house.run(1s);
        bool is_gone = false;
        for (int k = 0; k < 400; ++k) {
            const Frame frame = house.run(20ms).frame;
            is_gone = std::ranges::none_of(
                frame.items, [&](const DrawItem& item) { return item.source == second && item.alpha > 0; });
            for (const DrawItem& item : frame.items)
                if (item.source == second) CHECK(item.alpha <= waiting_light + 1e-9);
        }
        CHECK(is_gone);
    }
}

TEST_CASE("the only shot of a wall is flicked out and gives way to the idle picture without a jump") {
    House house = ::house({photo("a")});
    const SourceId only = house.run(2s).frame.items[0].source;
    house.is_dim = true;
    Gesture gesture{.kind = Gesture::Kind::drag,
                    .touch = 1,
                    .subject = only,
                    .at = {400, 225},
                    .from = {400, 225},
                    .moved = {1, 0}};
    house.wall.handle_gesture(gesture);
    gesture.kind = Gesture::Kind::flick;
    gesture.velocity = {0, -2000};
    house.wall.handle_gesture(gesture);
    house.run(1s);
    double idle = 0;
    for (int k = 0; k < 400; ++k) {
        const Frame frame = house.run(20ms).frame;
        CHECK(frame.idle - idle < 0.25);
        idle = frame.idle;
        for (const DrawItem& item : frame.items)
            CHECK(item.alpha <= waiting_light + 1e-9);
    }
    CHECK(idle == 1);
}

TEST_CASE("of a wall that has no more a shot that is flicked out stays away for a minute") {
    House house = ::house({photo("a"), photo("b"), photo("c")});
    house.run(2s);
    flick_second(house, {0, -900});
    house.run(8s);
    CHECK(shown_paths(house) == std::vector<std::string>{"a", "c"});
    house.run(60s);
    CHECK(shown_paths(house).size() == 3);
}

TEST_CASE("a finger need not wait for a change that is being prepared, which comes after it") {
    House house = ::house({photo("a"), photo("b"), photo("c"), photo("d")});
    house.run(2s);
    house.run(16500ms);  // the next shot is waiting for its turn
    REQUIRE(house.playing.size() == 4);
    Gesture gesture = on_second_shot(house, Gesture::Kind::hold);
    house.wall.handle_gesture(gesture);
    CHECK(house.run(1s).frame.items.size() == 4);
    CHECK(house.playing.size() == 4);
    gesture.kind = Gesture::Kind::release;
    house.wall.handle_gesture(gesture);
    house.run(4s);
    CHECK(areas(house).contains("d"));
}

TEST_CASE("the next shot is asked for seconds before it is seen, and no other waits beside it") {
    House house = ::house({film("a", 1, 5s), film("b", 1, 5s), film("c", 1, 5s), film("d", 1, 5s)}, 2);
    house.run(5s);
    std::map<SourceId, std::chrono::nanoseconds> asked;
    std::map<SourceId, std::chrono::nanoseconds> seen;
    while (house.now < 120s) {
        const WallStep step = house.step();
        for (const ShotRequest& request : step.requests)
            if (!seen.contains(request.source)) asked.try_emplace(request.source, step.frame.time);
        for (const DrawItem& item : step.frame.items)
            seen.try_emplace(item.source, step.frame.time);
        REQUIRE(house.playing.size() <= 3);
    }
    int changes = 0;
    for (const auto& [source, time] : asked) {
        if (!seen.contains(source)) continue;
        CHECK(seen.at(source) - time >= 2s);
        ++changes;
    }
    CHECK(changes > 6);
}

TEST_CASE("a film's shot is gone when its loop ends, not after it has begun again") {
    House house = ::house({film("a", 1, 7s), film("b", 1, 7s)}, 1);
    std::map<SourceId, std::chrono::nanoseconds> longest;
    while (house.now < 60s) {
        const WallStep step = house.step();
        for (const DrawItem& item : step.frame.items)
            longest[item.source] = std::max(longest[item.source], item.local);
    }
    REQUIRE(longest.size() == 3);
    CHECK(longest.begin()->second <= 21s + 50ms);
    CHECK(longest.begin()->second >= 21s - 100ms);
}

TEST_CASE("a change that would leave much of the canvas empty is laid out anew") {
    House house = ::house({photo("a"), photo("b"), photo("c"), photo("d")});
    house.plans = false;
    house.step();
    house.give(2);
    house.run(2s);
    REQUIRE(house.wall.count() == 3);
    while (house.planned.size() < 2)
        house.step();
    house.give(0.3);
    house.step();
    REQUIRE(house.planned.size() == 3);  // at once
    for (const PlanItem& item : house.planned.back().items) {
        CHECK_FALSE(item.previous);
        CHECK_FALSE(item.seat);
    }
    house.give(1.9);
    house.run(6s);
    CHECK(house.wall.shown()[0].placement.scale == 1.9);
    CHECK(house.wall.shown()[0].shot.key.path == "d");
}

TEST_CASE("where most shots are others, the wall is planned without the old places") {
    House house = ::house({photo("a"), photo("b"), photo("c")});
    house.run(5s);
    const auto refined = [](const std::string& path) {
        MediaRecord record = photo(path);
        record.shots.front().region.polygon = {{0, 0}, {40, 0}, {0, 40}};
        return record;
    };
    house.wall.set_catalogue(std::vector<MediaRecord>{photo("a"), photo("b"), refined("c")});
    house.run(5s);
    REQUIRE(house.planned.size() == 2);
    CHECK(house.planned.back().items[0].previous);
    CHECK(house.planned.back().items[2].seat);
    house.wall.set_catalogue(std::vector<MediaRecord>{refined("a"), refined("b"), refined("c")});
    house.run(5s);
    REQUIRE(house.planned.size() == 3);
    for (const PlanItem& item : house.planned.back().items) {
        CHECK_FALSE(item.previous);
        CHECK_FALSE(item.seat);
    }
}

TEST_CASE("a change laid out anew that is no better gives way to the calm one") {
    House house = ::house({photo("a"), photo("b"), photo("c"), photo("d")});
    house.plans = false;
    house.step();
    house.give(2);
    house.run(2s);
    while (house.planned.size() < 2)
        house.step();
    house.give(0.5);
    house.step();
    REQUIRE(house.planned.size() == 3);
    house.give(0.4);
    house.run(6s);
    CHECK(house.wall.shown()[0].placement.scale == 0.5);
}

TEST_CASE("a film that the store gets while it plays is asked for again, with its clip") {
    House house = ::house({film("a", 1), photo("b")});
    house.run(2s);
    REQUIRE(house.requests == 2);
    MediaRecord grown = film("a", 1);
    grown.shots[0].stored = {.file = "clip", .width = 320, .height = 180};
    house.wall.set_catalogue(std::vector{grown, photo("b")});
    house.run(1s);
    CHECK(house.requests == 3);
    CHECK(house.playing.begin()->second.shot.stored == grown.shots[0].stored);
    CHECK(house.planned.size() == 1);
    house.wall.set_catalogue(std::vector{grown, photo("b")});
    house.run(1s);
    CHECK(house.requests == 3);
}

namespace {

/// The times at which the frames of a calm wall began to change, and true if any shot has moved.
struct CalmRun {
    House house;
    std::vector<std::chrono::nanoseconds> begins{};
    bool has_moved = false;
    bool was_fading = false;

    void step() {
        const std::chrono::nanoseconds now = house.now;
        const WallStep step = house.step();
        bool is_fading = false;
        for (const DrawItem& item : step.frame.items)
            is_fading = is_fading || item.alpha < 1;
        if (is_fading && !was_fading) begins.push_back(now);
        was_fading = is_fading;
        std::set<double> allowed;  // the places on the old wall, which stands until the fade ends
        for (const PlacedShot& placed : house.wall.shown())
            allowed.insert(placed.placement.offset.x);
        for (const DrawItem& item : step.frame.items)
            if (item.alpha == 1 && item.placement.scale < 2 && !house.wall.shown().empty() &&
                !allowed.contains(item.placement.offset.x))
                has_moved = true;
    }

    void run(std::chrono::nanoseconds duration) {
        for (const auto end = house.now + duration; house.now < end;)
            step();
    }

    std::chrono::nanoseconds least_spacing() const {
        std::chrono::nanoseconds least = std::chrono::hours(1);
        for (std::size_t i = 1; i < begins.size(); ++i)
            least = std::min(least, begins[i] - begins[i - 1]);
        return least;
    }
};

CalmRun calm_run(int files) {
    CalmRun run{.house = {.wall = Wall({1280, 720},
                                       {.slots = {.count = 3, .order = ShotOrder::name}, .is_calm = true})}};
    run.house.wall.set_catalogue(photos(files));
    return run;
}

}  // namespace

TEST_CASE("on a calm wall nothing moves, and one change begins in five seconds, however many are wanted") {
    CalmRun run = calm_run(20);
    for (std::uint64_t turns = 0; turns < 40; ++turns) {
        run.house.wall.set_controls({.turns = turns});
        if (turns % 7 == 3) {
            auto records = photos(20);
            records.erase(records.begin() + static_cast<std::ptrdiff_t>(turns) / 7, records.begin() + 10);
            run.house.wall.set_catalogue(records);
        }
        run.house.wall.handle_gesture({.kind = turns % 2 == 0 ? Gesture::Kind::tap : Gesture::Kind::drag,
                                       .at = {700, 400},
                                       .from = {60 + 100.0 * static_cast<double>(turns % 3), 90}});
        run.run(1s);
    }
    CHECK(run.begins.size() >= 5);
    CHECK(run.least_spacing() >= 5s);
    CHECK_FALSE(run.has_moved);
}

TEST_CASE("the first calm wall comes as a whole") {
    CalmRun run = calm_run(3);
    run.house.readies = false;
    run.run(2s);
    REQUIRE(run.house.playing.size() == 3);
    run.house.wall.source_ready(run.house.playing.begin()->first);
    run.run(2s);
    CHECK(run.begins.empty());
    for (const auto& [source, request] : run.house.playing)
        run.house.wall.source_ready(source);
    run.run(2s);
    CHECK(run.begins.size() == 1);
    CHECK(run.house.wall.shown().size() == 3);
}

TEST_CASE("a long rotation with failures, additions and deletions leaves no source behind") {
    House house = ::house({});
    std::mt19937_64 engine(5);
    std::vector<MediaRecord> records;
    for (int i = 0; i < tries(150, 400); ++i) {
        if (engine() % 3 != 0)
            records.push_back(film("f" + std::to_string(engine() % 12), 1 + i % 4));
        else if (!records.empty())
            records.erase(records.begin() + static_cast<long>(engine() % records.size()));
        house.wall.set_catalogue(records);
        house.readies = engine() % 4 != 0;
        house.run(std::chrono::seconds(engine() % 20));
        if (engine() % 5 == 0 && !house.playing.empty()) {
            house.wall.source_failed(house.playing.begin()->first, house.now);
        }
        REQUIRE(house.playing.size() <= 6);
    }
    house.wall.set_catalogue({});
    house.run(20s);
    CHECK(house.playing.empty());
}
