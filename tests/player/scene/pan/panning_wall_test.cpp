#include "player/scene/pan/panning_wall.hpp"

#include "player/layout/plan/plan.hpp"
#include "player/scene/wall_cells.hpp"
#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

/// The player around a panning wall, without files and screen.
struct House {
    PanningWall wall{{640, 360}, {.ribbon = {.order = ShotOrder::name, .items_a_screen = 4}, .speed = 100}};
    std::chrono::nanoseconds now = 0s;
    bool readies = true;
    std::set<SourceId> playing{};
    std::set<std::string> seen{};
    int plans = 0;

    WallStep step() {
        WallStep step = wall.step(now);
        for (const ShotRequest& request : step.requests) {
            const bool is_new = playing.insert(request.source).second;
            REQUIRE((is_new || is_tapped));  // a shot that grows is asked for in another size
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

    /// A finger that goes on by so many px in each of `frames` frames, and is then lifted.
    void drag(double way, int frames, double flung = 0) {
        ++touch;
        for (int k = 1; k <= frames; ++k) {
            const Vec2 at{320 + way * k, 100};
            wall.handle_gesture({.kind = Gesture::Kind::drag,
                                 .touch = touch,
                                 .at = at,
                                 .from = {320, 100},
                                 .moved = {way, 0}});
            step();
        }
        const auto end = flung == 0 ? Gesture::Kind::drop : Gesture::Kind::flick;
        wall.handle_gesture({.kind = end, .touch = touch, .velocity = {flung, 0}});
    }

    void tap(Vec2 at) {
        const auto shot = wall.shot_at(at);
        REQUIRE(shot);
        is_tapped = true;
        wall.handle_gesture(
            {.kind = Gesture::Kind::tap, .touch = ++touch, .subject = shot->source, .at = at, .from = at});
    }

    std::uint64_t touch = 0;
    bool is_tapped = false;
};

/// Where the shots stand, by name: ribbon px.
std::map<std::string, double> places_in(const House& house, const WallStep& step) {
    std::map<std::string, double> places;
    for (const SlotShot& standing : house.wall.standing())
        for (const DrawItem& item : step.frame.items) {
            const Vec2 at = item.placement.offset - step.frame.view;
            const auto shot = house.wall.shot_at(at + Vec2{320, 180} * item.placement.scale);
            if (shot && shot->key == standing.key && shot->source == item.source)
                places[standing.key.path] = at.x + house.wall.view();
        }
    return places;
}

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
        CHECK(view - before <= 4.001);            // 100 px a second, 40 ms
        if (k > 40) CHECK(step.frame.idle == 0);  // the first shots have faded in
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

TEST_CASE("one shot alone is seen once on a screen, or twice where it passes") {
    House house;
    house.wall.set_catalogue(photos(1));
    for (int k = 0; k < 100; ++k)
        CHECK(house.step().frame.items.size() <= 2);
    CHECK(house.wall.view() > 200);
}

TEST_CASE("a notice takes the place of all at once, fading, and what was there comes back after it") {
    House house;
    const std::vector<MediaRecord> all = photos(12);
    const std::vector<MediaRecord> notice{photo("!NOW fire.jpg")};
    house.wall.set_catalogue(all);
    for (int k = 0; k < 60; ++k)
        house.step();
    for (const bool is_notice : {true, false}) {
        house.readies = false;
        house.wall.set_catalogue(is_notice ? notice : all);
        WallStep step = house.step();
        for (int k = 0; k < 20; ++k)
            step = house.step();  // its picture is not ready
        CHECK(step.frame.idle == 0);
        CHECK_FALSE(step.frame.items.empty());
        house.readies = true;
        for (const SourceId source : house.playing)
            house.wall.source_ready(source);
        bool is_mixed = false;
        for (int k = 0; k < 40; ++k) {
            step = house.step();
            CHECK(step.frame.idle == 0);
            is_mixed = is_mixed || std::ranges::any_of(step.frame.items, [](const DrawItem& item) {
                           return item.alpha > 0.4 && item.alpha < 0.6;
                       });
        }
        CHECK(is_mixed);
        for (const SlotShot& standing : house.wall.standing())
            CHECK((standing.key.path == "!NOW fire.jpg") == is_notice);
        CHECK(house.playing.size() < 14);
        CHECK(std::ranges::all_of(step.frame.items, [](const DrawItem& item) { return item.alpha == 1; }));
    }
}

TEST_CASE("a notice that is taken away while it fades in leaves no moment without a picture") {
    House house;
    house.wall.set_catalogue(photos(12));
    for (int k = 0; k < 60; ++k)
        house.step();
    house.wall.set_catalogue(std::vector<MediaRecord>{photo("!NOW fire.jpg")});
    const auto is_fading = [](const WallStep& step) {
        return std::ranges::any_of(step.frame.items, [](const DrawItem& item) { return item.alpha < 1; });
    };
    int waited = 0;
    while (!is_fading(house.step()) && waited < 60)
        ++waited;
    REQUIRE(waited < 60);
    house.wall.set_catalogue(photos(12));
    house.readies = false;
    for (int k = 0; k < 30; ++k)
        CHECK(house.step().frame.idle == 0);
    house.readies = true;
    for (const SourceId source : house.playing)
        house.wall.source_ready(source);
    for (int k = 0; k < 60; ++k)
        CHECK(house.step().frame.idle == 0);
    for (const SlotShot& standing : house.wall.standing())
        CHECK(standing.key.path != "!NOW fire.jpg");
}

TEST_CASE(
    "once all files are gone a panning wall fades to the idle picture, and to further files from there") {
    House house;
    house.wall.set_catalogue(photos(12));
    for (int k = 0; k < 60; ++k)
        house.step();
    house.wall.set_catalogue(std::vector<MediaRecord>{});
    bool is_mixed = false;
    for (int k = 0; k < 40; ++k) {
        const std::vector<DrawItem> items = house.step().frame.items;
        is_mixed = is_mixed || std::ranges::any_of(items, [](const DrawItem& item) {
                       return item.alpha > 0.4 && item.alpha < 0.6;
                   });
    }
    CHECK(is_mixed);
    CHECK(house.step().frame.items.empty());
    CHECK(house.step().frame.idle == 1);
    CHECK(house.playing.empty());
    house.wall.set_catalogue(photos(3));
    for (int k = 0; k < 60; ++k)
        house.step();
    CHECK_FALSE(house.step().frame.items.empty());
    CHECK(house.step().frame.idle == 0);
}

TEST_CASE("another screen while a notice comes begins anew and leaves no source behind") {
    House house;
    house.wall.set_catalogue(photos(12));
    for (int k = 0; k < 60; ++k)
        house.step();
    house.wall.set_catalogue(std::vector<MediaRecord>{photo("!NOW fire.jpg")});
    house.step();
    house.wall.set_canvas({360, 640});
    for (int k = 0; k < 60; ++k)
        house.step();
    CHECK(house.playing.size() <= 4);
    for (const SlotShot& standing : house.wall.standing())
        CHECK(standing.key.path == "!NOW fire.jpg");
}

TEST_CASE("another screen begins anew and leaves no source behind") {
    House house;
    house.wall.set_catalogue(photos(12));
    for (int k = 0; k < 60; ++k)
        house.step();
    house.wall.set_canvas({360, 640});
    for (int k = 0; k < 60; ++k)
        CHECK_FALSE(house.step().frame.items.empty());
    CHECK(house.wall.view() > 0);
    CHECK(house.playing.size() < 20);
}

TEST_CASE("a display that comes leaves a panning wall as it is until the new one fades in") {
    House house;
    Canvas right = canvas_of({640, 360}, {{{0, 0}, {640, 360}}});
    right.origin = {700, 0};
    house.wall.set_canvas(right);
    house.wall.set_catalogue(photos(12));
    WallStep before = house.step();
    for (int k = 0; k < 60; ++k)
        before = house.step();
    house.readies = false;
    house.wall.set_canvas(canvas_of({1340, 360}, {{{0, 0}, {640, 360}}, {{700, 0}, {1340, 360}}}));
    for (int k = 0; k < 20; ++k) {
        const Frame frame = house.step().frame;
        REQUIRE(frame.items.size() == before.frame.items.size());
        for (std::size_t i = 0; i < frame.items.size(); ++i) {
            const Vec2 was = before.frame.items[i].placement.offset - before.frame.view;
            CHECK(length(frame.items[i].placement.offset - frame.view - was - Vec2{700, 0}) < 1e-6);
        }
        CHECK(frame.idle == 1);  // on the display that has come
    }
    house.readies = true;
    for (const SourceId source : house.playing)
        house.wall.source_ready(source);
    for (int k = 0; k < 40; ++k)
        CHECK_FALSE(house.step().frame.items.empty());
    CHECK(house.step().frame.idle == 0);
}

TEST_CASE(
    "the first shots fade in over the idle picture, all at once, or those that there are after a while") {
    for (const bool comes : {true, false}) {
        House house;
        house.readies = false;
        house.wall.set_catalogue(photos(12));
        for (int k = 0; k < 60; ++k)
            CHECK(house.step().frame.idle == 1);
        const std::vector<const PlacedShot*> coming = house.wall.parts().coming;
        const auto in_view = std::ranges::find_if(
            coming, [](const PlacedShot* shot) { return bounds_of(*shot->cell).min.x < 200; });
        REQUIRE(in_view != coming.end());
        const SourceId missing = comes ? 0 : (*in_view)->shot.source;
        for (const SourceId source : house.playing)
            if (source != missing) house.wall.source_ready(source);
        bool is_mixed = false;
        int waited = 0;
        for (; waited < 300 && !is_mixed; ++waited) {
            const WallStep step = house.step();
            CHECK(step.frame.idle == 1);
            is_mixed = std::ranges::any_of(
                step.frame.items, [](const DrawItem& item) { return item.alpha > 0.4 && item.alpha < 0.6; });
        }
        CHECK(is_mixed);
        CHECK((waited < 30) == comes);
        house.readies = true;
        for (int k = 0; k < 20; ++k)
            house.step();
        CHECK((house.step().frame.idle == 0) == comes);
    }
}

TEST_CASE("a finger drags the view, and what has passed is where it was") {
    House house;
    house.wall.set_catalogue(photos(30));
    for (int k = 0; k < 300; ++k)
        house.step();
    const double begin = house.wall.view();
    const auto before = places_in(house, house.step());
    REQUIRE_FALSE(before.empty());
    house.drag(-30, 10);
    CHECK(house.wall.view() == doctest::Approx(begin + 300).epsilon(0.02));
    house.drag(60, 10);
    CHECK(house.wall.view() < begin - 200);
    house.drag(-30, 10);
    int same = 0;
    for (const auto& [name, x] : places_in(house, house.step()))
        if (const auto known = before.find(name); known != before.end()) {
            CHECK(known->second == doctest::Approx(x));
            ++same;
        }
    CHECK(same >= 2);
}

TEST_CASE("a finger takes the view a screen back and no farther, and all that is seen has a picture") {
    House house;
    house.wall.set_catalogue(photos(30));
    for (int k = 0; k < 500; ++k)
        house.step();
    const double begin = house.wall.view();
    house.drag(40, 60);
    CHECK(house.wall.view() >= begin - 640 * 2);
    CHECK(house.wall.view() < begin - 300);
    house.drag(-40, 200);
    CHECK(house.wall.view() > begin);
    for (int k = 0; k < 1500; ++k)
        house.step();
    CHECK(house.playing.size() <= 14);  // as if nobody had touched it
}

TEST_CASE("a flung view glides on and becomes as slow as before") {
    House house;
    house.wall.set_catalogue(photos(60));
    for (int k = 0; k < 100; ++k)
        house.step();
    house.drag(-20, 3, -1500);
    const double begin = house.wall.view();
    for (int k = 0; k < 25; ++k)
        house.step();
    CHECK(house.wall.view() - begin > 400);
    for (int k = 0; k < 150; ++k)
        house.step();
    const double end = house.wall.view();
    house.step();
    CHECK(house.wall.view() - end <= 4.5);
}

TEST_CASE("a tapped shot grows to the whole screen while the view stands; another tap lets it go on") {
    House house;
    house.wall.set_catalogue(photos(30));
    for (int k = 0; k < 100; ++k)
        house.step();
    house.tap({320, 180});
    house.step();
    const double view = house.wall.view();
    for (int k = 0; k < 30; ++k)
        house.step();
    CHECK(house.wall.view() == view);
    const WallStep large = house.step();
    REQUIRE_FALSE(large.frame.items.empty());
    const DrawItem& top = large.frame.items.back();
    CHECK(top.placement.offset.x - large.frame.view.x == doctest::Approx(0).epsilon(0.01));
    CHECK(top.placement.scale * 640 == doctest::Approx(640));
    house.tap({320, 180});
    for (int k = 0; k < 60; ++k)
        house.step();
    CHECK(house.wall.view() > view);
}
