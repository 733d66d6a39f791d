#include "player/scene/tapestry/woven_strips.hpp"

#include "player/scene/tapestry/tapestry_show.hpp"
#include "player/scene/tapestry/unwoven_tapestry.hpp"
#include "tests/player/scene/tapestry/drawn_tapestry.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr auto step_time = 20ms;

/// The same film twice as tall, of other keyframes, without its coarsest level and with a finer one.
Tapestry taller_tapestry() {
    Tapestry tapestry = drawn_tapestry(5);
    tapestry.folder = "tiles-sharp";
    tapestry.height *= 2;
    tapestry.brick_width *= 2;
    for (TapestryLevel& level : tapestry.levels)
        level.width *= 2;
    tapestry.levels.erase(tapestry.levels.begin());
    return tapestry;
}

/// A strip whose tiles come at once; those of a newer tapestry come when they are let.
struct Loom {
    explicit Loom(Tapestry first)
        : strip(std::move(first), drawn_film(), {640, 360}, {.first_source = 1000, .patience = {}}) {}

    TapestryStep step() {
        TapestryStep step = strip.step(now);
        for (const TileId& tile : step.missing)
            strip.strips().add(strip.sources().generation, tile, {});
        if (lets_come && strip.strips().coming()) {
            const unsigned generation = strip.strips().coming()->strip().sources().generation;
            for (const TileId& tile : step.coming)
                strip.strips().add(generation, tile, {});
        }
        retired.insert(step.retired.begin(), step.retired.end());
        now += step_time;
        return step;
    }

    TapestryStep run(std::chrono::nanoseconds duration) {
        TapestryStep last = step();
        for (const auto end = now + duration; now < end;)
            last = step();
        return last;
    }

    /// The total opacity of what a frame draws of a strip's tiles.
    double opacity(const TapestryStep& step, TapestrySources sources) const {
        double sum = 0;
        for (const DrawItem& item : step.frame.items)
            for (std::size_t level = 0; level < 5; ++level)
                for (int tile = 0; tile < 40; ++tile)
                    if (item.source == sources.tile({level, tile})) sum += item.alpha;
        return sum;
    }

    TapestryShow strip;
    std::chrono::nanoseconds now = 0s;
    std::set<SourceId> retired{};
    bool lets_come = true;
};

}  // namespace

TEST_CASE("a newer tapestry takes over with the same moment in the middle, at the same scale") {
    for (const int nearer : {2, 3}) {  // there the film reaches beyond the screen
        CAPTURE(nearer);
        Loom loom(drawn_tapestry());
        for (int k = 0; k < nearer; ++k) {
            loom.strip.handle_gesture({.kind = Gesture::Kind::key, .key = Key::nearer});
            loom.run(1s);
        }
        loom.strip.handle_gesture(
            {.kind = Gesture::Kind::drag, .at = {300, 280}, .from = {330, 280}, .moved = {-30, 0}});
        loom.strip.handle_gesture({.kind = Gesture::Kind::drop, .at = {300, 280}, .from = {330, 280}});
        loom.run(1s);
        const TapestryView before = loom.strip.view();
        const double width = loom.strip.place().width(before.level);

        loom.strip.strips().take_over(taller_tapestry());
        loom.run(1s);
        REQUIRE(loom.strip.tapestry().folder == "tiles-sharp");
        const TapestryView after = loom.strip.view();
        CHECK(std::chrono::abs(after.centre - before.centre) < 1ms);
        CHECK(after.level == std::round(after.level));
        CHECK(loom.strip.place().width(after.level) == doctest::Approx(width).epsilon(0.001));
    }
}

TEST_CASE("the older tapestry is shown until the newer one covers it, and then goes") {
    Loom loom(drawn_tapestry());
    loom.run(1s);
    const TapestrySources older = loom.strip.sources();
    loom.lets_come = false;
    loom.strip.strips().take_over(taller_tapestry());
    const TapestryStep waiting = loom.run(1s);
    CHECK_FALSE(waiting.coming.empty());
    CHECK(loom.opacity(waiting, older) >= 1);
    REQUIRE(loom.strip.strips().coming());
    const TapestrySources newer = loom.strip.strips().coming()->strip().sources();
    CHECK(loom.opacity(waiting, newer) == 0);

    loom.lets_come = true;
    loom.step();
    double shown = 0;
    for (int frame = 0; frame < 14; ++frame) {  // the newer one fades in, over the older one
        const TapestryStep step = loom.step();
        CHECK(loom.opacity(step, older) >= 1);
        CHECK(loom.opacity(step, newer) >= shown);
        shown = loom.opacity(step, newer);
    }
    CHECK(shown > 0.5);
    const TapestryStep after = loom.run(500ms);
    CHECK(loom.opacity(after, older) == 0);
    CHECK(loom.opacity(after, newer) >= 1);
    CHECK(loom.retired.contains(older.tile({0, 0})));
}

TEST_CASE("a newer tapestry that cannot be read is not shown, and its late tiles do no harm") {
    Loom loom(drawn_tapestry());
    loom.lets_come = false;
    loom.strip.strips().take_over(taller_tapestry());
    loom.run(1s);
    loom.strip.strips().drop_coming();
    loom.strip.strips().add(1, {0, 0}, {});
    loom.run(1s);
    CHECK(loom.strip.tapestry().folder == "tiles");
    loom.lets_come = true;
    loom.strip.strips().take_over(taller_tapestry());
    loom.run(1s);
    CHECK(loom.strip.tapestry().folder == "tiles-sharp");
    CHECK(loom.strip.sources().generation == 2);
}

TEST_CASE("a film that is not woven yet has a place for its strip, of the film's times") {
    Tapestry unwoven = unwoven_tapestry(60s, {160, 90});
    REQUIRE(is_unwoven(unwoven));
    Loom loom(std::move(unwoven));
    const TapestryStep step = loom.run(1s);
    CHECK(step.missing.empty());
    CHECK(step.coming.empty());
    const auto place = std::ranges::find(step.frame.items, loom.strip.sources().mark(), &DrawItem::source);
    REQUIRE(place != step.frame.items.end());
    CHECK(place->picture.x > 600);
    CHECK(place->alpha < 0.2);
    CHECK(loom.strip.place().canvas_x({.centre = 30s}, 30s) == doctest::Approx(320));

    const auto centre = loom.strip.view().centre;
    loom.strip.strips().take_over(drawn_tapestry());
    const TapestryStep woven = loom.run(1s);
    CHECK(loom.opacity(woven, loom.strip.sources()) >= 1);
    CHECK(loom.strip.tapestry().folder == "tiles");
    CHECK(std::chrono::abs(loom.strip.view().centre - centre) < 1ms);
}
