#include "player/scene/tapestry/tapestry_show.hpp"

#include "player/scene/tapestry/kept_frames.hpp"
#include "tests/player/scene/tapestry/drawn_tapestry.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

using Kind = Gesture::Kind;

constexpr Vec2 on_strip{200, 280};  // canvas px, on a canvas of 640 x 360; in the lower row
constexpr double upper_row = 250;   // canvas px
constexpr auto frame_time = 16'666'667ns;

/// The player around a strip: tiles come at once, films when they are asked for.
struct House {
    TapestryShow strip{drawn_tapestry(), drawn_film(), {640, 360}, {.first_source = 1000, .patience = {}}};
    std::chrono::nanoseconds now = 0s;
    std::set<SourceId> tiles{};
    std::vector<ShotRequest> playing{};
    bool readies = true;

    TapestryStep step(const TapestryMoment* seen = nullptr) {
        TapestryStep step = strip.step(now, seen);
        for (const TileId& tile : step.missing) {
            tiles.insert(strip.sources().tile(tile));
            strip.strips().add(strip.sources().generation, tile, {});
        }
        for (const SourceId source : step.retired) {
            tiles.erase(source);
            std::erase_if(playing, [&](const ShotRequest& request) { return request.source == source; });
        }
        for (const ShotRequest& request : step.requests) {
            playing.push_back(request);
            if (readies) strip.source_ready(request.source);
        }
        now += frame_time;
        return step;
    }

    TapestryStep run(std::chrono::nanoseconds duration) {
        TapestryStep last = step();
        for (const auto end = now + duration; now < end;)
            last = step();
        return last;
    }

    double x(std::chrono::nanoseconds time) const { return strip.place().canvas_x(strip.view(), time); }

    std::chrono::nanoseconds time_at(double x) const { return strip.place().time_at(strip.view(), x); }

    void set_shots(std::vector<Shot> shots) { strip.set_film(drawn_film(std::move(shots))); }

    void tap(Vec2 at) { strip.handle_gesture({.kind = Kind::tap, .at = at, .from = at}); }

    void go_to_level(int level) {
        for (int k = 0; k < level; ++k) {
            strip.handle_gesture({.kind = Kind::key, .key = Key::nearer});
            run(1s);
        }
    }

    /// The item of a source in a frame; nullptr: it is not drawn.
    static const DrawItem* item(const Frame& frame, SourceId source) {
        const auto found = std::ranges::find(frame.items, source, &DrawItem::source);
        return found == frame.items.end() ? nullptr : &*found;
    }

    /// The place of the line at the film's time, canvas px; none: it is not seen.
    std::optional<double> line(const Frame& frame) const {
        const DrawItem* const mark = item(frame, strip.sources().mark());
        if (mark == nullptr) return std::nullopt;
        const Box at = bounding_box(mark->cell->parts[0]);
        return (at.min.x + at.max.x) / 2;
    }
};

}  // namespace

TEST_CASE("a strip is covered by its tiles in every frame, whatever one does") {
    House house;
    house.step();
    const auto check = [&](std::chrono::nanoseconds duration) {
        for (const auto end = house.now + duration; house.now < end;) {
            const Frame frame = house.step().frame;
            const double right = std::min(640.0, house.x(60s));
            double reached = std::max(0.0, house.x(0s));
            for (const DrawItem& item : frame.items) {
                if (!house.tiles.contains(item.source) || item.alpha < 1) continue;
                const Box box = bounding_box(item.cell->parts[0]);
                if (box.min.x <= reached + 1e-6) reached = std::max(reached, box.max.x);
            }
            REQUIRE(reached >= right - 1e-6);
        }
    };
    for (int k = 0; k < 3; ++k) {
        house.strip.handle_gesture({.kind = Kind::wheel, .at = on_strip, .from = on_strip, .factor = 1.25});
        check(800ms);
    }
    house.strip.handle_gesture(
        {.kind = Kind::flick, .at = on_strip, .from = on_strip, .velocity = {-3000, 0}});
    check(2s);
    for (int k = 0; k < 20; ++k) {
        house.strip.handle_gesture({.kind = Kind::pinch, .at = on_strip, .from = on_strip, .factor = 0.93});
        check(40ms);
    }
    house.strip.handle_gesture({.kind = Kind::pinch_end, .at = on_strip, .from = on_strip});
    check(30s);
}

TEST_CASE("what a frame says is covered is covered, by the strip and by the film that plays above it") {
    House house;
    int covered = 0;
    int playing = 0;
    const auto check = [&](std::chrono::nanoseconds duration) {
        for (const auto end = house.now + duration; house.now < end;) {
            const Frame frame = house.step().frame;
            for (const Box& box : frame.covered) {
                ++covered;
                playing += box == tapestry_boxes({640, 360}, {160, 90}).preview;
                double reached = box.min.x;
                for (const DrawItem& item : frame.items) {
                    const Box drawn = bounding_box(item.cell->parts[0]);
                    if (item.alpha >= 1 && drawn.min.x <= reached + 1e-6 && drawn.min.y <= box.min.y &&
                        drawn.max.y >= box.max.y)
                        reached = std::max(reached, drawn.max.x);
                }
                REQUIRE(reached >= box.max.x - 1e-6);
            }
        }
    };
    CHECK(house.step().frame.covered.empty());  // no tile is there yet
    check(200ms);
    CHECK(covered > 0);
    CHECK(playing == 0);
    house.strip.handle_gesture({.kind = Kind::tap, .at = on_strip, .from = on_strip});
    house.strip.handle_gesture({.kind = Kind::wheel, .at = on_strip, .from = on_strip, .factor = 1.25});
    check(2s);
    house.strip.handle_gesture(
        {.kind = Kind::flick, .at = on_strip, .from = on_strip, .velocity = {-3000, 0}});
    check(2s);
    for (int k = 0; k < 20; ++k) {
        house.strip.handle_gesture({.kind = Kind::pinch, .at = on_strip, .from = on_strip, .factor = 0.9});
        check(40ms);
    }
    CHECK(playing > 100);
}

TEST_CASE("a notch of the wheel is one level in 0.6 seconds, about the pointer") {
    House house;
    house.step();
    for (int k = 0; k < 2; ++k) {
        house.strip.handle_gesture({.kind = Kind::key, .key = Key::nearer});
        house.run(1s);
    }
    REQUIRE(house.strip.view().level == 2);
    house.strip.handle_gesture({.kind = Kind::wheel, .at = {320, 280}, .from = {320, 280}, .factor = 1.25});
    const auto held = house.time_at(320);
    house.step();
    const auto began = house.now - frame_time;
    while (house.strip.view().level < 3) {
        house.step();
        CHECK(house.x(held) == doctest::Approx(320).epsilon(1e-3));
    }
    CHECK(house.now - frame_time - began >= 600ms);
    CHECK(house.now - frame_time - began < 600ms + 2 * frame_time);
}

TEST_CASE("a strip that is let go between two levels comes to rest at the nearest") {
    House house;
    house.step();
    house.strip.handle_gesture({.kind = Kind::pinch, .at = on_strip, .from = on_strip, .factor = 1.7});
    CHECK(house.strip.view().level > 0.5);
    CHECK(house.strip.view().level < 1);
    house.strip.handle_gesture({.kind = Kind::pinch_end, .at = on_strip, .from = on_strip});
    house.run(1s);
    CHECK(house.strip.view().level == 1);
}

TEST_CASE("a strip goes with the finger, and on after a flick, ever slower") {
    House house;
    house.step();
    for (int k = 0; k < 3; ++k) {
        house.strip.handle_gesture({.kind = Kind::key, .key = Key::nearer});
        house.run(1s);
    }
    const auto held = house.time_at(400);
    house.strip.handle_gesture({.kind = Kind::drag, .at = {350, 280}, .from = {400, 280}, .moved = {-50, 0}});
    CHECK(house.x(held) == doctest::Approx(350).epsilon(1e-3));
    house.strip.handle_gesture(
        {.kind = Kind::flick, .at = {350, 280}, .from = {400, 280}, .velocity = {-600, 0}});
    double last = house.x(held);
    double way = 0;
    for (int k = 0; k < 10; ++k) {
        house.run(100ms);
        const double went = last - house.x(held);
        if (k > 0) CHECK(went < way);
        way = went;
        last = house.x(held);
    }
    CHECK(last < 350 - 100);
    CHECK(last > 350 - 600 * 0.35 - 1);
    house.run(3s);
    const double rest = house.x(held);
    house.run(1s);
    CHECK(house.x(held) == rest);
}

TEST_CASE("a tap plays the film from there above the strip and in place, and a line goes along with it") {
    House house;
    house.run(1s);
    const auto time = house.strip.place().picture_at(house.strip.view(), {300, 280}).time;
    house.tap({300, 280});
    const TapestryStep step = house.run(500ms);
    REQUIRE(house.playing.size() == 2);
    for (const ShotRequest& request : house.playing) {
        CHECK(request.path == "film.mp4");
        CHECK(request.shot.begin == time);
    }
    const auto find = [&](SourceId source) {
        return std::ranges::find(step.frame.items, source, &DrawItem::source);
    };
    const auto above = find(house.playing[0].source);
    REQUIRE(above != step.frame.items.end());
    CHECK(bounding_box(above->cell->parts[0]).max.y < house.strip.place().box().min.y);
    CHECK(above->local > 400ms);
    const auto in_place = find(house.playing[1].source);
    REQUIRE(in_place != step.frame.items.end());
    CHECK(bounding_box(in_place->cell->parts[0]).min.y >= house.strip.place().box().min.y);
    CHECK(bounding_box(in_place->cell->parts[0]).max.y <= house.strip.place().box().max.y);
    const auto line = find(house.strip.sources().mark());
    REQUIRE(line != step.frame.items.end());
    const Box at = bounding_box(line->cell->parts[0]);
    CHECK((at.min.x + at.max.x) / 2 == doctest::Approx(house.x(time + above->local)).epsilon(0.01));
}

TEST_CASE(
    "what plays stays until what was tapped next is ready; a film that fails leaves the strip as it was") {
    House house;
    house.run(1s);
    house.strip.handle_gesture({.kind = Kind::tap, .at = {300, 280}, .from = {300, 280}});
    house.run(500ms);
    const SourceId first = house.playing[0].source;
    house.readies = false;
    house.strip.handle_gesture({.kind = Kind::tap, .at = {400, 280}, .from = {400, 280}});
    TapestryStep step = house.run(500ms);
    CHECK(std::ranges::count(step.frame.items, first, &DrawItem::source) == 1);
    for (const ShotRequest& request : std::vector(house.playing))
        house.strip.source_failed(request.source);
    step = house.run(500ms);
    CHECK(std::ranges::count(step.frame.items, first, &DrawItem::source) == 0);
    CHECK(house.playing.empty());
}

TEST_CASE("a steady pan never comes to a tile that is not there, though each takes a while") {
    TapestryShow strip(drawn_tapestry(), drawn_film(), {640, 360}, {.first_source = 1000});
    std::deque<std::pair<TileId, std::chrono::nanoseconds>> coming;
    std::chrono::nanoseconds now = 0s;
    std::size_t missed = 0;
    const auto step = [&] {
        const TapestryStep done = strip.step(now);
        for (const TileId& tile : done.missing)
            if (coming.empty()) coming.emplace_back(tile, now + 80ms);  // one after the other
        if (!coming.empty() && coming.front().second <= now) {
            strip.strips().add(strip.sources().generation, coming.front().first, {});
            coming.pop_front();
        }
        const TapestryPlace place = strip.place();
        const auto level = static_cast<std::size_t>(std::lround(strip.view().level));
        for (const auto& [tile, middle] : place.tiles(strip.view(), level, 0, 640))
            if (std::ranges::count(done.frame.items, strip.sources().tile(tile), &DrawItem::source) == 0)
                ++missed;
        now += frame_time;
    };
    for (int k = 0; k < 3; ++k) {
        strip.handle_gesture({.kind = Kind::key, .key = Key::nearer});
        for (int frame = 0; frame < 60; ++frame)
            step();
    }
    for (int frame = 0; frame < 60; ++frame)
        step();
    REQUIRE(strip.view().level == 3);
    missed = 0;
    const auto begin = strip.view().centre;
    for (int frame = 0; frame < 240; ++frame) {
        strip.handle_gesture({.kind = Kind::drag, .at = {300, 280}, .from = {400, 280}, .moved = {-4, 0}});
        step();
    }
    CHECK(strip.view().centre > begin + 10s);
    CHECK(missed == 0);
}

TEST_CASE("what plays is read from the store where the store has it, and from the film between") {
    const auto shot = [](std::chrono::nanoseconds begin, std::chrono::nanoseconds end, const char* file) {
        Shot made{.begin = begin, .end = end, .stored = {}};
        if (*file != 0) made.stored = StoredShot{.file = file, .begin = 100ms, .width = 160, .height = 90};
        return made;
    };
    House house;
    house.set_shots({shot(0s, 20s, "a/0.mp4"), shot(21s, 25s, "a/1.mp4"), shot(25s, 60s, "")});
    house.run(1s);
    const auto keyframe = drawn_tapestry().levels[0].keyframes[2];  // 15.95 s
    house.tap({house.x(keyframe), upper_row});
    TapestryStep step = house.run(200ms);
    REQUIRE(house.playing.size() == 2);
    for (const ShotRequest& request : house.playing) {
        REQUIRE(request.shot.stored);
        CHECK(request.shot.stored->file == "a/0.mp4");
        CHECK(request.shot.begin == keyframe);
        CHECK(request.shot.stored->begin == 100ms + keyframe);
    }
    const ShotRequest above =
        std::ranges::max(house.playing, {}, [](const auto& one) { return one.shot.end; });
    CHECK(above.shot.end == 20s);

    house.run(3s);  // what lies between the shots is got ready, and comes when this one ends
    REQUIRE(house.playing.size() == 3);
    const ShotRequest between = house.playing[2];
    CHECK(between.shot.begin == 20s);
    CHECK(between.shot.end == 21s);
    CHECK_FALSE(between.shot.stored);
    step = house.step();
    CHECK(House::item(step.frame, above.source) != nullptr);
    CHECK(House::item(step.frame, between.source) == nullptr);
    step = house.run(1s);
    CHECK(House::item(step.frame, above.source) == nullptr);
    CHECK(House::item(step.frame, between.source) != nullptr);
    const ShotRequest next = house.playing.back();
    CHECK(next.shot.begin == 21s);
    CHECK(next.shot.end == 25s);
    CHECK(next.shot.stored->file == "a/1.mp4");
    CHECK(next.shot.stored->begin == 100ms);
}

TEST_CASE("a strip begins where it was asked for, as far as the film's ends allow") {
    TapestryShow strip(drawn_tapestry(), drawn_film(), {200, 360}, {.patience = {}, .first_seen = 20s});
    CHECK(strip.step(0s).requests.empty());
    CHECK(strip.view().level == 0);
    CHECK(std::chrono::abs(strip.view().centre - 20s) < 1ms);
    TapestryShow last(drawn_tapestry(), drawn_film(), {200, 360},
                      {.patience = {}, .plays_at_once = true, .first_seen = 55s});
    const TapestryStep step = last.step(0s);
    REQUIRE(step.requests.size() == 1);
    CHECK(step.requests[0].shot.begin == 55s);
    CHECK(last.place().canvas_x(last.view(), 60s) == doctest::Approx(200));
}

TEST_CASE("a film that is to play at once does so on a canvas of another size, too") {
    TapestryShow strip(drawn_tapestry(), drawn_film(), {1920, 1080},
                       {.first_source = 1000, .patience = {}, .plays_at_once = true, .first_seen = 20s});
    strip.set_room({640, 360});
    const TapestryStep step = strip.step(0s);
    REQUIRE(!step.requests.empty());
    const ShotRequest& request = step.requests.back();
    CHECK(request.shot.begin == 20s);
    strip.source_ready(request.source);
    const TapestryStep next = strip.step(frame_time);
    CHECK(std::ranges::find(next.frame.items, request.source, &DrawItem::source) != next.frame.items.end());
}

TEST_CASE("what plays stands at its end until the next shot is ready") {
    House house;
    house.set_shots({Shot{.begin = 0s, .end = 3s, .stored = StoredShot{.file = "a/0.mp4"}},
                     Shot{.begin = 3s, .end = 60s, .stored = StoredShot{.file = "a/1.mp4"}}});
    house.run(1s);
    house.strip.handle_gesture({.kind = Kind::key, .key = Key::select});
    house.run(100ms);
    const auto first = drawn_tapestry().levels[0].keyframes[0];
    house.tap({house.x(first), upper_row});
    house.run(200ms);
    house.readies = false;
    const TapestryStep step = house.run(4s);
    const auto plays = std::ranges::find_if(step.frame.items, [&](const DrawItem& item) {
        return item.cell && bounding_box(item.cell->parts[0]).max.y < house.strip.place().box().min.y;
    });
    REQUIRE(plays != step.frame.items.end());
    CHECK(plays->local == 3s - first - 2ms);
}

TEST_CASE(
    "fingers that come together at the coarsest level leave the strip, and a tap beside the preview does") {
    House house;
    house.run(1s);
    house.strip.handle_gesture({.kind = Kind::pinch, .at = on_strip, .from = on_strip, .factor = 0.9});
    CHECK_FALSE(house.strip.is_over());
    house.strip.handle_gesture({.kind = Kind::pinch, .at = on_strip, .from = on_strip, .factor = 0.8});
    CHECK(house.strip.is_over());

    House other;
    other.run(1s);
    other.strip.handle_gesture({.kind = Kind::tap, .at = on_strip, .from = on_strip});
    other.run(500ms);
    other.strip.handle_gesture(
        {.kind = Kind::tap, .at = {320, 100}, .from = {320, 100}});  // puts the preview away
    CHECK_FALSE(other.strip.is_over());
    other.run(500ms);
    other.strip.handle_gesture({.kind = Kind::tap, .at = {10, 100}, .from = {10, 100}});
    CHECK(other.strip.is_over());
}

TEST_CASE("by itself it goes through the film, nearer and farther, and plays what is in the middle") {
    House house;
    std::set<long> levels;
    std::set<long> places;
    for (int k = 0; k < 90; ++k) {
        house.run(1s);
        levels.insert(std::lround(house.strip.view().level));
        places.insert(house.strip.view().centre / 2s);
    }
    CHECK(levels.size() == 4);
    CHECK(places.size() > 5);
    CHECK_FALSE(house.playing.empty());
    CHECK_FALSE(house.strip.is_over());
    house.strip.handle_gesture({.kind = Kind::tap, .at = {320, 20}, .from = {320, 20}});
    house.run(1s);
    const TapestryView view = house.strip.view();
    house.run(3s);
    CHECK(house.strip.view() == view);  // somebody is there
}

TEST_CASE("a strip is over when nobody has touched it for long, or at the key for it") {
    TapestryShow strip(drawn_tapestry(), drawn_film(), {640, 360}, {.patience = 30s});
    strip.step(0s);
    strip.handle_gesture({.kind = Kind::tap, .at = on_strip, .from = on_strip});
    strip.step(20s);
    strip.step(49s);
    CHECK_FALSE(strip.is_over());
    strip.step(50s);
    CHECK(strip.is_over());
    TapestryShow other(drawn_tapestry(), drawn_film(), {640, 360}, {});
    other.handle_gesture({.kind = Kind::key, .key = Key::back});
    CHECK(other.is_over());
}

TEST_CASE("a strip that is closed gives back all that it asked for") {
    House house;
    house.run(1s);
    house.strip.handle_gesture({.kind = Kind::tap, .at = on_strip, .from = on_strip});
    house.run(1s);
    REQUIRE(house.playing.size() == 2);
    const std::vector<SourceId> sources = house.strip.close();
    for (const SourceId source : house.tiles)
        CHECK(std::ranges::count(sources, source) == 1);
    for (const ShotRequest& request : house.playing)
        CHECK(std::ranges::count(sources, request.source) == 1);
}

TEST_CASE("what plays stays in view, and the strip goes along with it") {
    House house;
    house.run(1s);
    house.go_to_level(3);
    house.tap({600, upper_row});
    house.run(100ms);
    for (int k = 0; k < 20 * 60; ++k) {
        const std::optional<double> line = house.line(house.step().frame);
        REQUIRE(line);
        REQUIRE(*line >= 0);
        REQUIRE(*line <= 640);
        if (k > 120) CHECK(*line < 0.75 * 640);
    }
}

TEST_CASE(
    "a strip that a visitor has flung away from what plays stays there, and goes along again from there") {
    House house;
    house.run(1s);
    house.go_to_level(3);
    house.tap({300, upper_row});
    house.run(500ms);
    house.strip.handle_gesture({.kind = Kind::key, .key = Key::left});
    house.strip.handle_gesture(
        {.kind = Kind::flick, .at = on_strip, .from = on_strip, .velocity = {3000, 0}});
    house.run(2s);
    CHECK_FALSE(house.line(house.step().frame));
    const TapestryView view = house.strip.view();
    house.run(2s);
    CHECK(house.strip.view() == view);
    const std::optional<double> line = house.line(house.run(6s).frame);  // the film may have come into view
    if (line) CHECK(*line <= 640);
}

TEST_CASE("at the film's end the wall comes back, a moment after its last picture") {
    TapestryShow strip(drawn_tapestry(), drawn_film(), {640, 360},
                       {.patience = 300s, .plays_at_once = true, .first_seen = 50s});
    std::chrono::nanoseconds now = 0s;
    const auto run = [&](std::chrono::nanoseconds until) {
        for (; now < until; now += frame_time)
            for (const ShotRequest& request : strip.step(now).requests)
                strip.source_ready(request.source);
    };
    run(12s);
    CHECK_FALSE(strip.is_over());
    run(14s);
    CHECK(strip.is_over());
}

TEST_CASE("where there is no wall, the film begins anew at its end") {
    House house;
    house.run(1s);
    house.tap({house.x(59s), 280});
    house.run(35s);
    CHECK_FALSE(house.strip.is_over());
    CHECK(std::ranges::count_if(house.playing, [](const auto& one) { return one.shot.begin < 10s; }) > 0);
}

TEST_CASE("a finger that goes over the strip sees the moment under it above; letting go plays from there") {
    House house;
    house.run(1s);
    house.go_to_level(2);
    house.tap({320, 280});
    house.run(1s);
    house.strip.handle_gesture({.kind = Kind::hold, .at = {200, 280}, .from = {200, 280}});
    house.step();
    const TapestryView view = house.strip.view();
    ShotRequest shown;
    for (double x = 200; x <= 400; x += 10) {
        house.strip.handle_gesture(
            {.kind = Kind::drag, .at = {x, 280}, .from = {200, 280}, .moved = {10, 0}});
        house.step();  // asks for the moment
        const Frame frame = house.step().frame;
        CHECK(house.strip.view() == view);
        CHECK(*house.line(frame) == doctest::Approx(x).epsilon(0.01));
        shown = house.playing.back();
        CHECK(std::chrono::abs(shown.shot.begin - house.time_at(x)) < 50ms);
        const DrawItem* const above = House::item(frame, shown.source);
        REQUIRE(above != nullptr);
        CHECK(above->local == 0ns);
        CHECK(bounding_box(above->cell->parts[0]) == tapestry_boxes({640, 360}, {160, 90}).preview);
    }
    house.run(500ms);
    house.strip.handle_gesture({.kind = Kind::drop, .at = {400, 280}, .from = {200, 280}});
    const Frame frame = house.run(500ms).frame;
    CHECK(house.playing.back().source == shown.source);  // the picture goes on: nothing is asked for again
    REQUIRE(House::item(frame, shown.source) != nullptr);
    CHECK(House::item(frame, shown.source)->local > 400ms);
}

TEST_CASE("a frame that was kept stands for the moment under the finger at once, with its time in digits") {
    Tapestry tapestry = drawn_tapestry();
    tapestry.kept = {.width = 32, .height = 18, .columns = 4, .rows = 4, .times = {}};
    for (int frame = 0; frame < 120; ++frame)
        tapestry.kept.times.push_back(500ms * frame);
    tapestry.digits = {.width = 30, .height = 48};
    TapestryShow strip(tapestry, drawn_film(), {640, 360}, {.first_source = 1000});
    std::chrono::nanoseconds now = 0s;
    const auto step = [&] {
        TapestryStep done = strip.step(now);
        for (const TileId& tile : done.missing)
            strip.strips().add(strip.sources().generation, tile, {});
        now += frame_time;
        return done;
    };
    step();
    step();
    const Box preview = tapestry_boxes({640, 360}, {160, 90}).preview;
    for (double x = 180; x < 460; x += 7) {  // the whole film is in view
        strip.handle_gesture({.kind = Kind::drag, .at = {x, 280}, .from = {180, 280}, .moved = {7, 0}});
        step();
        const Frame frame = step().frame;
        const auto moment = strip.place().time_at(strip.view(), x);
        const auto kept =
            std::clamp<std::int64_t>(std::llround(static_cast<double>(moment / 1ms) / 500), 0, 119);
        const DrawItem* const sheet =
            House::item(frame, strip.sources().tile({.level = 4, .tile = static_cast<int>(kept / 16)}));
        REQUIRE(sheet != nullptr);
        const Vec2 cell{static_cast<double>(kept % 16 % 4), static_cast<double>(kept % 16 / 4)};
        const Vec2 middle = (preview.min + preview.max) * 0.5;
        CHECK((middle.x - sheet->placement.offset.x) / sheet->picture.x ==
              doctest::Approx((cell.x + 0.5) / 4).epsilon(1e-6));
        CHECK((middle.y - sheet->placement.offset.y) / sheet->picture.y ==
              doctest::Approx((cell.y + 0.5) / 4).epsilon(1e-6));
        CHECK(bounding_box(sheet->cell->parts[0]) == preview);
        const SourceId digits = strip.sources().tile({.level = 5, .tile = 0});
        CHECK(std::ranges::count(frame.items, digits, &DrawItem::source) == 4);
    }
}

TEST_CASE("a time is told in minutes and seconds, with hours where there are any") {
    CHECK(time_in_words(0s) == "0:00");
    CHECK(time_in_words(59999ms) == "0:59");
    CHECK(time_in_words(125s) == "2:05");
    CHECK(time_in_words(3725s) == "1:02:05");
}

TEST_CASE("one moment after another is asked for, however fast the finger is; none stays behind") {
    House house;
    house.run(1s);
    house.readies = false;
    house.strip.handle_gesture({.kind = Kind::hold, .at = {100, 280}, .from = {100, 280}});
    house.strip.handle_gesture({.kind = Kind::release, .at = {100, 280}, .from = {100, 280}});
    house.run(100ms);
    const std::size_t before = house.playing.size();
    for (double x = 100; x < 600; x += 5) {
        house.strip.handle_gesture({.kind = Kind::drag, .at = {x, 280}, .from = {100, 280}, .moved = {5, 0}});
        house.step();
        CHECK(house.playing.size() <= before + 1);
    }
    const ShotRequest first = house.playing.back();
    house.strip.source_ready(first.source);
    house.step();
    house.step();
    const ShotRequest second = house.playing.back();
    CHECK(second.source != first.source);
    CHECK(std::chrono::abs(second.shot.begin -
                           std::min<std::chrono::nanoseconds>(house.time_at(595), 59600ms)) < 50ms);
    house.strip.source_ready(second.source);
    house.run(100ms);
    CHECK(std::ranges::count(house.playing, first.source, &ShotRequest::source) == 0);
}

TEST_CASE("a finger that takes the line of the film's time goes over the strip; one elsewhere takes the "
          "strip along") {
    House house;
    house.run(1s);
    house.go_to_level(3);
    house.tap({320, 280});
    const double line = *house.line(house.run(200ms).frame);
    const TapestryView view = house.strip.view();
    const auto drag = [&](double from) {
        house.strip.handle_gesture(
            {.kind = Kind::drag, .at = {from + 30, 280}, .from = {from, 280}, .moved = {30, 0}});
        house.step();
        const TapestryView moved = house.strip.view();
        house.strip.handle_gesture({.kind = Kind::drop, .at = {from + 30, 280}, .from = {from, 280}});
        return moved;
    };
    CHECK(drag(line + 5) == view);
    house.run(200ms);
    const auto held = house.time_at(100);
    drag(100);
    CHECK(house.x(held) == doctest::Approx(130).epsilon(0.01));
    CHECK(std::chrono::abs(house.playing.back().shot.begin - held) <
          50ms);  // and plays from under the finger
}

TEST_CASE("every moment of the film can be reached with a finger, from any level") {
    for (const int level : {0, 2}) {
        House house;
        house.run(1s);
        house.go_to_level(level);
        std::set<long> seen;  // halves of a second
        const auto go_to = [&](double x) {
            house.strip.handle_gesture({.kind = Kind::drag, .at = {x, 280}, .from = {320, 280}, .moved = {}});
            house.step();
            seen.insert((house.playing.back().shot.begin + 5ms) / 500ms);
        };
        house.strip.handle_gesture({.kind = Kind::hold, .at = {320, 280}, .from = {320, 280}});
        go_to(320);
        for (int k = 0; k < 60 * 4; ++k)
            go_to(2);  // at the edge the strip comes towards the finger
        for (double x = 2; x < 588; x += 1)
            go_to(x);
        for (int k = 0; k < 60 * 18; ++k)
            go_to(592);  // there it comes slowly
        for (double x = 592; x < 640; x += 0.25)
            go_to(x);
        CHECK(seen.size() >= 119);  // of 120; the last pictures are too short a part to play
    }
}

namespace {

/// A strip that leads, and one of another box that follows. The film is in the store from a time on.
struct TwoBoxes {
    House leads{}, follows{};
    std::chrono::nanoseconds ahead = 5s;  // of the clock of the one that follows
    TapestryStep led{}, followed{};

    /// @param edited  the keyframes that touches change; none: touches change none
    explicit TwoBoxes(std::chrono::nanoseconds stored_from = 0s,
                      const std::optional<KeyframeChoice>& edited = {})
        : leads{.strip{drawn_tapestry(),
                       drawn_film(),
                       {640, 360},
                       {.first_source = 1000, .patience = {}, .edited = edited}}} {
        follows.now += ahead;
        for (House* const house : {&leads, &follows})
            house->set_shots({stored_shot(stored_from, 40s), stored_shot(40s, 60s)});
    }

    static Shot stored_shot(std::chrono::nanoseconds begin, std::chrono::nanoseconds end) {
        return {.begin = begin, .end = end, .stored = StoredShot{.file = "clip", .begin = begin}};
    }

    /// Runs both. The one that follows gets each frame's moment at once.
    void run(std::chrono::nanoseconds duration) {
        for (const auto end = leads.now + duration; leads.now < end;) {
            led = leads.step();
            const TapestryMoment seen = moved(led.seen, ahead);
            followed = follows.step(&seen);
        }
    }

    /// True if both show the strip, the line and the film's pictures alike.
    bool look_alike() const {
        if (led.frame.items.size() != followed.frame.items.size()) return false;
        for (std::size_t i = 0; i < led.frame.items.size(); ++i) {
            const DrawItem& one = led.frame.items[i];
            const DrawItem& other = followed.frame.items[i];
            const auto film_time = [](const House& house, const DrawItem& item) {
                const auto found = std::ranges::find(house.playing, item.source, &ShotRequest::source);
                return found == house.playing.end() ? std::chrono::nanoseconds(-1)
                                                    : found->shot.begin + item.local;
            };
            if (film_time(leads, one) != film_time(follows, other)) return false;
            if (one.placement != other.placement || one.picture != other.picture) return false;
            if (std::abs(one.alpha - other.alpha) > 1e-9) return false;
        }
        return true;
    }

    void touch(Kind kind, Vec2 at, Vec2 moved = {}) {
        leads.strip.handle_gesture({.kind = kind, .at = at, .from = on_strip, .moved = moved});
    }
};

}  // namespace

TEST_CASE("another box shows the same of a tapestry, whatever a hand does") {
    TwoBoxes boxes;
    boxes.run(1s);
    CHECK(boxes.look_alike());
    boxes.touch(Kind::tap, {500, upper_row});  // plays above and in place
    boxes.run(2s);
    CHECK(boxes.led.seen.above);
    CHECK(boxes.led.seen.in_place);
    CHECK(boxes.look_alike());
    for (const Key key : {Key::nearer, Key::nearer, Key::farther}) {
        boxes.leads.strip.handle_gesture({.kind = Kind::key, .key = key});
        for (int k = 0; k < 12; ++k) {
            boxes.run(frame_time);
            CHECK(boxes.look_alike());
        }
        boxes.run(1s);
    }
    for (int k = 0; k < 20; ++k) {
        boxes.touch(Kind::drag, on_strip + Vec2{-9.0 * k, 0}, {-9, 0});
        boxes.run(frame_time);
        CHECK(boxes.look_alike());
    }
    CHECK(boxes.led.seen.looked_for);
    boxes.touch(Kind::drop, on_strip + Vec2{-180, 0});
    boxes.run(200ms);
    CHECK_FALSE(boxes.led.seen.looked_for);
    CHECK(boxes.look_alike());
    boxes.run(30s);  // by itself, over the border of two shots
    CHECK(boxes.look_alike());
}

TEST_CASE("another box shows the marks of keyframes that are edited") {
    TwoBoxes boxes(0s, KeyframeChoice{.keyframes = {31s}});
    boxes.run(1s);
    CHECK(boxes.look_alike());
    const std::size_t before = boxes.followed.frame.items.size();
    boxes.touch(Kind::tap, {250, upper_row});  // strikes a picture: a veil and a dash
    boxes.run(1s);
    CHECK(boxes.look_alike());
    CHECK(boxes.followed.frame.items.size() == before + 2);
}

TEST_CASE("a box that comes later plays the film from where it is") {
    TwoBoxes boxes;
    boxes.leads.tap({500, upper_row});
    boxes.leads.run(4s);
    boxes.follows.now = boxes.leads.now + boxes.ahead;
    boxes.run(500ms);
    CHECK(boxes.look_alike());
    const auto begins = [](const House& house) {  // of the part above the strip, which ends with the shot
        const auto found =
            std::ranges::find_if(house.playing, [](const auto& request) { return request.shot.end == 40s; });
        return found == house.playing.end() ? 0ns : found->shot.begin;
    };
    CHECK(begins(boxes.leads) > 10s);
    CHECK(begins(boxes.follows) > begins(boxes.leads) + 3s);
}

TEST_CASE("a moment that was before is played by another source: no source goes back") {
    TwoBoxes boxes;
    std::map<SourceId, std::chrono::nanoseconds> last;
    for (int k = 0; k < 300; ++k) {
        if (k % 150 == 0) boxes.leads.tap({500, upper_row});
        boxes.run(frame_time);
        for (const DrawItem& item : boxes.followed.frame.items) {
            const auto found = last.find(item.source);
            if (found != last.end()) CHECK(item.local >= found->second);
            last[item.source] = item.local;
        }
    }
    CHECK(boxes.look_alike());
}

TEST_CASE("a box without the film itself asks for nothing that the store has not got") {
    TwoBoxes boxes(10s);
    boxes.leads.tap({20, upper_row});  // in the first ten seconds
    boxes.run(2s);
    REQUIRE(boxes.led.seen.above);
    REQUIRE(boxes.led.seen.above->span.begin < 8s);
    CHECK(boxes.follows.playing.empty());
    const std::optional<double> line = boxes.follows.line(boxes.followed.frame);
    REQUIRE(line);
    CHECK(*line == doctest::Approx(*boxes.leads.line(boxes.led.frame)));
    boxes.run(11s);
    REQUIRE_FALSE(boxes.follows.playing.empty());
    CHECK(boxes.follows.playing.front().shot.stored);
    boxes.follows.readies = false;
    boxes.leads.tap({600, upper_row});
    boxes.run(100ms);
    for (int k = 0; k < 10; ++k) {  // it fails, and is not asked for again
        for (const ShotRequest& request : std::vector(boxes.follows.playing))
            boxes.follows.strip.source_failed(request.source);
        boxes.run(500ms);
    }
    CHECK(boxes.follows.playing.empty());
    boxes.follows.set_shots({TwoBoxes::stored_shot(10s, 40s), TwoBoxes::stored_shot(40s, 60s)});
    boxes.run(100ms);
    CHECK_FALSE(boxes.follows.playing.empty());  // its record is another one: the store may have it now
}

TEST_CASE("a tapestry on a canvas with bezels is that of one screen: its film crosses none, its strip all") {
    const Canvas canvas = canvas_of({1340, 360}, {{{0, 0}, {640, 360}}, {{700, 0}, {1340, 360}}});
    for (const Vec2 at : {Vec2{500, 100}, Vec2{720, 100}}) {
        const Box screen = output_at(canvas, at);
        TapestryShow strip(drawn_tapestry(), drawn_film(), tapestry_room(canvas, at), {.first_source = 1000});
        const TapestryStep step = strip.step(0s);
        CHECK(step.seen.room.screen == screen);
        const TapestryBoxes boxes = tapestry_boxes(tapestry_room(canvas, at), drawn_film().picture);
        const TapestryBoxes alone = tapestry_boxes({640, 360}, drawn_film().picture);
        CHECK(boxes.preview == moved(alone.preview, screen.min));
        CHECK(boxes.strip == Box{alone.strip.min, {1340, alone.strip.max.y}});
        CHECK(strip.place().canvas_x(strip.view(), strip.view().centre) ==
              doctest::Approx(screen.centre().x));
    }
    CHECK(tapestry_room({640, 360}, {9, 9}) == TapestryRoom(640, 360));
    const Canvas touching = canvas_of({1280, 360}, {{{0, 0}, {640, 360}}, {{640, 0}, {1280, 360}}});
    CHECK(tapestry_room(touching, {9, 9}).screen == Box{{0, 0}, {1280, 360}});
}

TEST_CASE("a tap on a screen below that of the tapestry is not on its strip") {
    const Canvas canvas = canvas_of({640, 780}, {{{0, 0}, {640, 360}}, {{0, 420}, {640, 780}}});
    for (const auto& [y, closes] : {std::pair{280, false}, std::pair{358, false}, std::pair{700, true}}) {
        TapestryShow strip(drawn_tapestry(), drawn_film(), tapestry_room(canvas, {9, 9}),
                           {.first_source = 1000});
        strip.step(0s);
        const Vec2 at{320, static_cast<double>(y)};
        strip.handle_gesture({.kind = Kind::tap, .at = at, .from = at});
        CHECK(strip.is_over() == closes);
    }
}
