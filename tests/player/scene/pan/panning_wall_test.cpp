#include "player/scene/pan/panning_wall.hpp"

#include "player/layout/plan/plan.hpp"
#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

#include <map>
#include <set>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

/// The player around a panning wall, without files and screen.
struct House {
    PanningWall wall{{640, 360}, {.order = ShotOrder::name, .items_a_screen = 4, .speed = 100}};
    std::chrono::nanoseconds now = 0s;
    bool readies = true;
    std::set<SourceId> playing{};
    std::set<std::string> seen{};
    int plans = 0;

    WallStep step() {
        WallStep step = wall.step(now);
        for (const ShotRequest& request : step.requests) {
            REQUIRE(playing.insert(request.source).second);
            if (readies) wall.source_ready(request.source);
        }
        for (const SourceId source : step.retired)
            REQUIRE(playing.erase(source) == 1);
        for (const DrawItem& item : step.frame.items)
            REQUIRE(playing.contains(item.source));
        if (step.plan) {
            ++plans;
            PlanRequest request{.canvas = step.plan->canvas, .budget = 3'000, .fills = false};
            request.items = step.plan->items;
            Layout layout = plan(request);
            layout.generation = step.plan->generation;
            layout.is_final = true;
            wall.set_layout(layout);
        }
        now += 40ms;
        return step;
    }
};

}  // namespace

TEST_CASE("an empty catalogue pans over nothing") {
    House house;
    CHECK(house.step().frame.idle == 1);
    CHECK(house.plans == 0);
}

TEST_CASE("the view moves on steadily, sources come before it and retire behind it") {
    House house;
    house.wall.set_catalogue(photos(30));
    double before = 0;
    for (int k = 0; k < 800; ++k) {
        const WallStep step = house.step();
        const double view = house.wall.view();
        CHECK(view >= before);
        CHECK(view - before <= 4.001);  // 100 px a second, 40 ms
        before = view;
        REQUIRE(house.playing.size() <= 14);
    }
    CHECK(before > 2900);
    CHECK(house.plans >= 4);
}

TEST_CASE("what is in view stands still against its neighbours while more is laid out ahead") {
    House house;
    house.wall.set_catalogue(photos(30));
    std::map<SourceId, double> places;  // x from where the wall began
    for (int k = 0; k < 500; ++k) {
        const WallStep step = house.step();
        for (const DrawItem& item : step.frame.items) {
            const double base = house.wall.view() - step.frame.view.x;
            const double x = item.placement.offset.x + base;
            const auto [known, is_new] = places.emplace(item.source, x);
            REQUIRE(known->second == doctest::Approx(x));
        }
    }
    CHECK(places.size() > 10);
}

TEST_CASE("the view waits for a source that is late") {
    House house;
    house.readies = false;
    house.wall.set_catalogue(photos(12));
    for (int k = 0; k < 50; ++k)
        house.step();
    CHECK(house.wall.view() == 0);
    for (const SourceId source : house.playing)
        house.wall.source_ready(source);
    for (int k = 0; k < 20; ++k)
        house.step();
    CHECK(house.wall.view() > 0);
}

TEST_CASE("few shots come again and again") {
    House house;
    house.wall.set_catalogue(photos(3));
    for (int k = 0; k < 400; ++k)
        house.step();
    CHECK(house.wall.view() > 1000);
}

TEST_CASE("another screen begins anew and leaves no source behind") {
    House house;
    house.wall.set_catalogue(photos(12));
    for (int k = 0; k < 60; ++k)
        house.step();
    house.wall.set_canvas({360, 640});
    for (int k = 0; k < 60; ++k)
        house.step();
    CHECK(house.wall.view() > 0);
    CHECK(house.playing.size() < 20);
}
