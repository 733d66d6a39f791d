#include "player/scene/crossfade.hpp"

#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

PlacedShot placed(SourceId source, std::chrono::nanoseconds began = 0s, double scale = 1) {
    WallShot shot{.source = source, .kind = MediaKind::film, .picture = {640, 360}};
    shot.shot = {.begin = 10s, .end = 14s, .region = {.polygon = middle().polygon, .drift = {12, -8}}};
    Cell cell;
    cell.parts = {{{0, 0}, {10.0 * static_cast<double>(source), 0}, {10, 10}}};
    return {.shot = shot,
            .placement = {.scale = scale, .offset = {5, 6}},
            .cell = std::make_shared<const Cell>(cell),
            .began = began};
}

std::vector<SourceId> sources(const Frame& frame) {
    std::vector<SourceId> sources;
    for (const DrawItem& item : frame.items)
        sources.push_back(item.source);
    return sources;
}

}  // namespace

TEST_CASE("a wall that stands is drawn once and opaque, without the idle picture") {
    const std::vector<PlacedShot> wall{placed(1), placed(2)};
    const Frame frame = crossfade({20, 10}, wall, {}, 0, 3s);
    CHECK(sources(frame) == std::vector<SourceId>{1, 2});
    CHECK(frame.items[0].alpha == 1);
    CHECK(frame.items[1].alpha == 1);
    CHECK(frame.idle == 0);
    CHECK(frame.time == 3s);
    CHECK(frame.canvas == Vec2{20, 10});
    CHECK(frame.items[0].placement == wall[0].placement);
    CHECK(frame.items[0].picture == Vec2{640, 360});
    CHECK(frame.items[0].cell == wall[0].cell);
}

TEST_CASE("a shot that has not begun shows its first picture, also before the wall's time begins") {
    for (const auto now : {-2s, 0s, 3s})
        CHECK(standing_frame({1280, 720}, std::vector{placed(1, never)}, now).items[0].local == 0s);
    CHECK(standing_frame({1280, 720}, std::vector{placed(1, 1s)}, 3s).items[0].local == 2s);
}

TEST_CASE("nothing on the wall is the idle picture") {
    CHECK(crossfade({1280, 720}, {}, {}, 0, 0s).idle == 1);
    CHECK(crossfade({1280, 720}, {}, {}, 0.5, 0s).idle == 1);
    CHECK(crossfade({1280, 720}, {}, {}, 1, 0s).items.empty());
}

TEST_CASE("the new wall fades in over the old one, which is drawn whole") {
    const std::vector<PlacedShot> old_wall{placed(1), placed(2)};
    const std::vector<PlacedShot> new_wall{placed(3), placed(4)};
    const Frame frame = crossfade({20, 10}, old_wall, new_wall, 0.25, 0s);
    CHECK(sources(frame) == std::vector<SourceId>{1, 2, 3, 4});
    CHECK(frame.items[0].alpha == 1);
    CHECK(frame.items[1].alpha == 1);
    CHECK(frame.items[2].alpha == doctest::Approx(0.15625));  // 3/16 - 2/64
    CHECK(frame.items[3].alpha == frame.items[2].alpha);
    CHECK(frame.idle == 0);
    CHECK(sources(crossfade({20, 10}, old_wall, new_wall, 1, 0s)) == std::vector<SourceId>{3, 4});
}

TEST_CASE("the idle picture is below a wall that was laid out for a smaller canvas") {
    const std::vector<PlacedShot> old_wall{placed(1)};  // 10 x 10 px
    const std::vector<PlacedShot> new_wall{placed(2)};
    CHECK(standing_frame({10, 10}, old_wall, 0s).idle == 0);
    CHECK(standing_frame({12, 10}, old_wall, 0s).idle == 1);
    CHECK(crossfade({20, 10}, old_wall, new_wall, 0.25, 0s).idle == 1);
    CHECK(crossfade({20, 10}, old_wall, new_wall, 1, 0s).idle == 0);
}

TEST_CASE("what stays as it is is drawn once during a transition, what moves twice") {
    const std::vector<PlacedShot> old_wall{placed(1), placed(2)};
    const std::vector<PlacedShot> new_wall{placed(1), placed(2, 0s, 1.5)};
    CHECK(sources(crossfade({1280, 720}, old_wall, new_wall, 0.5, 0s)) == std::vector<SourceId>{1, 2, 2});
}

TEST_CASE("between the idle picture and a wall only the wall changes its opacity") {
    const std::vector<PlacedShot> wall{placed(1)};
    const Frame coming = crossfade({1280, 720}, {}, wall, 0.25, 0s);
    CHECK(coming.idle == 1);
    CHECK(coming.items.at(0).alpha == doctest::Approx(0.15625));
    const Frame going = crossfade({1280, 720}, wall, {}, 0.25, 0s);
    CHECK(going.idle == 1);
    CHECK(going.items.at(0).alpha == doctest::Approx(0.84375));
}

TEST_CASE(
    "the shots of a first wall come over the idle picture until all are there, each since it appeared") {
    std::vector<PlacedShot> wall{placed(1, 10s), placed(2, 11s), placed(3, never)};
    const Frame coming = fade_in_each({1280, 720}, wall, 2s, 11500ms);
    CHECK(coming.idle == 1);
    REQUIRE(coming.items.size() == 2);
    CHECK(coming.items[0].alpha == doctest::Approx(0.84375));
    CHECK(coming.items[0].local == 1500ms);
    CHECK(coming.items[1].alpha == doctest::Approx(0.15625));
    CHECK(fade_in_each({1280, 720}, wall, 0s, 12s).items[1].alpha == 1);
}

TEST_CASE("frames look alike as long as nothing but time differs") {
    const std::vector<PlacedShot> wall{placed(1), placed(2)};
    const Frame frame = crossfade({1280, 720}, wall, {}, 0, 1s);
    Frame later = crossfade({1280, 720}, wall, {}, 0, 1s + 4s);  // a loop
    CHECK(looks_alike(frame, later));
    CHECK_FALSE(looks_alike(frame, crossfade({1280, 720}, std::span(wall).first(1), {}, 0, 1s)));
    const auto differs = [&](auto change) {
        Frame other = frame;
        change(other);
        return !looks_alike(frame, other);
    };
    CHECK(differs([](Frame& f) { f.canvas.x += 1; }));
    CHECK(differs([](Frame& f) { f.view.x += 1; }));
    CHECK(differs([](Frame& f) { f.idle = 0.5; }));
    CHECK(differs([](Frame& f) { f.items[1].source = 7; }));
    CHECK(differs([](Frame& f) { f.items[1].cell = std::make_shared<const Cell>(); }));
    CHECK(differs([](Frame& f) { f.items[1].placement.scale *= 2; }));
    CHECK(differs([](Frame& f) { f.items[1].alpha = 0.5; }));
}

TEST_CASE("a shot plays from the time on when it appeared") {
    const std::vector<PlacedShot> wall{placed(1, 20s)};
    CHECK(standing_frame({1280, 720}, wall, 29s).items.at(0).local == 9s);
    CHECK(standing_frame({1280, 720}, wall, 19s).items.at(0).local == 0s);
}

TEST_CASE("a frame that fades in lets what was there before fade out") {
    Frame frame{.canvas = {1280, 720}, .items = {{.source = 1}}};
    const LeavingFrame before{.items = {{.source = 2}}, .idle = 0};
    Frame coming = frame;
    fade_in(coming, before, 0.25);
    CHECK(coming.idle == doctest::Approx(0.15625));  // what is dim shows it
    CHECK(coming.is_fade);
    CHECK(sources(coming) == std::vector<SourceId>{2, 1});
    CHECK(coming.items[0].alpha == doctest::Approx(0.84375));
    CHECK(coming.items[1].alpha == doctest::Approx(0.15625));
    Frame early = frame;
    fade_in(early, before, 0.25, 0.25);
    CHECK(early.items[0].alpha == 1);  // the idle picture does not shine through
    CHECK(early.items[1].alpha == doctest::Approx(0.15625));
    Frame late = frame;
    fade_in(late, before, 0.9, 0.25);
    CHECK(late.items[0].alpha == doctest::Approx(0.112));
    CHECK(late.items[1].alpha == doctest::Approx(0.972));
    fade_in(frame, {}, 0.25);
    CHECK(frame.idle == 1);
    CHECK(sources(frame) == std::vector<SourceId>{1});
}

TEST_CASE("easing starts and ends slowly and stays in [0, 1]") {
    CHECK(eased(-1) == 0);
    CHECK(eased(0) == 0);
    CHECK(eased(0.5) == 0.5);
    CHECK(eased(1) == 1);
    CHECK(eased(2) == 1);
    CHECK(eased(0.1) < 0.1);
    CHECK(eased(0.9) > 0.9);
}
