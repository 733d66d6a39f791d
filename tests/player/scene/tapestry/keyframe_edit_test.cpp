#include "player/scene/tapestry/keyframe_edit.hpp"

#include "player/scene/tapestry/tapestry_show.hpp"
#include "tests/player/scene/tapestry/drawn_tapestry.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

using Kind = Gesture::Kind;

constexpr auto frame_time = 20ms;
constexpr Vec2 on_film{320, 100};  // canvas px, on a canvas of 640 x 360

/// A technician before a strip: tiles and films come at once.
struct Editor {
    Editor() : strip(drawn_tapestry(), drawn_film(), {640, 360}, settings()) { run(1s); }

    static TapestrySettings settings() {
        return {.first_source = 1000, .patience = 30s, .plays_at_once = true, .edited = KeyframeChoice{}};
    }

    Frame run(std::chrono::nanoseconds duration) {
        Frame last;
        for (const auto end = now + duration; now < end; now += frame_time) {
            TapestryStep step = strip.step(now);
            for (const TileId& tile : step.missing)
                strip.strips().add(strip.sources().generation, tile, {});
            for (const ShotRequest& request : step.requests)
                strip.source_ready(request.source);
            last = std::move(step.frame);
        }
        return last;
    }

    void tap(Vec2 at) { strip.handle_gesture({.kind = Kind::tap, .at = at, .from = at}); }

    /// A finger goes over the strip to a place and lets go.
    void look_at(double x) {
        strip.handle_gesture({.kind = Kind::hold, .at = {200, 280}, .from = {200, 280}});
        strip.handle_gesture({.kind = Kind::drag, .at = {x, 280}, .from = {200, 280}, .moved = {x - 200, 0}});
        run(200ms);
        strip.handle_gesture({.kind = Kind::drop, .at = {x, 280}, .from = {200, 280}});
        strip.handle_gesture({.kind = Kind::release, .at = {x, 280}, .from = {200, 280}});
    }

    /// The white things that a frame has below the strip, canvas px.
    std::vector<Box> marks(const Frame& frame) const {
        std::vector<Box> marks;
        for (const DrawItem& item : frame.items) {
            if (item.source != strip.sources().mark()) continue;
            const Box at = bounding_box(item.cell->parts[0]);
            if (at.min.y > strip.place().box().max.y) marks.push_back(at);
        }
        return marks;
    }

    TapestryShow strip;
    std::chrono::nanoseconds now{0};
};

}  // namespace

TEST_CASE("a tap on a picture strikes it, and a second one takes that back") {
    Editor editor;
    const StripPicture picture = editor.strip.place().picture_at(editor.strip.view(), {320, 280});
    editor.tap({320, 280});
    CHECK(editor.strip.take_choice() == KeyframeChoice{.struck = {picture.time}});
    CHECK_FALSE(editor.strip.take_choice());
    const Frame frame = editor.run(20ms);
    REQUIRE(editor.marks(frame).size() == 1);
    CHECK(editor.marks(frame)[0].width() > editor.marks(frame)[0].height());
    const Box brick = editor.strip.place().brick(editor.strip.view(), picture, {160, 90});
    CHECK(std::ranges::any_of(frame.items, [&](const DrawItem& item) {
        return item.source == editor.strip.sources().mark() && item.alpha < 0.7 &&
               std::abs(bounding_box(item.cell->parts[0]).max.x - brick.max.x) < 1;
    }));
    editor.tap({320, 280});
    CHECK(editor.strip.take_choice() == KeyframeChoice{});
    CHECK(editor.marks(editor.run(20ms)).empty());
}

TEST_CASE(
    "the film stands where a finger has let go; a tap on it makes that moment a keyframe, and it plays on") {
    Editor editor;
    editor.look_at(400);
    const auto moment = editor.strip.place().time_at(editor.strip.view(), 400);
    editor.run(3s);  // the film waits
    editor.tap(on_film);
    const std::optional<KeyframeChoice> choice = editor.strip.take_choice();
    REQUIRE(choice);
    REQUIRE(choice->keyframes.size() == 1);
    CHECK(std::chrono::abs(choice->keyframes[0] - moment) < 50ms);
    const Frame frame = editor.run(1s);
    CHECK_FALSE(editor.strip.is_over());
    REQUIRE(editor.marks(frame).size() == 1);
    CHECK(editor.marks(frame)[0].width() < editor.marks(frame)[0].height());
    editor.tap(on_film);  // about a second later
    const std::optional<KeyframeChoice> next = editor.strip.take_choice();
    REQUIRE(next);
    REQUIRE(next->keyframes.size() == 2);
    CHECK(next->keyframes[1] - moment > 700ms);
}

TEST_CASE("a tap on the mark of a choice takes it back, and one beside every mark changes nothing") {
    Editor editor;
    editor.look_at(400);
    editor.tap(on_film);
    REQUIRE(editor.strip.take_choice());
    const Box mark = editor.marks(editor.run(20ms)).at(0);
    editor.tap({mark.min.x - 60, mark.min.y});
    CHECK_FALSE(editor.strip.take_choice());
    editor.tap({mark.min.x + 8, mark.max.y});
    CHECK(editor.strip.take_choice() == KeyframeChoice{});
}

TEST_CASE("while keyframes are edited the film begins anew at its end, and the wall does not come back") {
    Editor editor;
    editor.strip.handle_gesture({.kind = Kind::key, .key = Key::select});
    for (int k = 0; k < 6; ++k) {  // the film is a minute long
        editor.run(20s);
        editor.tap({320, 280});
    }
    CHECK_FALSE(editor.strip.is_over());
}

TEST_CASE("a keyframe that was chosen takes the place of struck ones beside it, and the other way round") {
    KeyframeEdit edit({.keyframes = {10s}, .struck = {20s}});
    CHECK_FALSE(edit.take_changed());
    edit.choose(20300ms);
    CHECK(edit.take_changed() == KeyframeChoice{.keyframes = {10s, 20300ms}});
    edit.choose(20600ms);
    CHECK(edit.take_changed() == KeyframeChoice{.keyframes = {10s, 20600ms}});
    edit.touch_picture(10200ms);
    CHECK(edit.take_changed() == KeyframeChoice{.keyframes = {20600ms}});
    edit.touch_picture(10200ms);
    CHECK(edit.take_changed() == KeyframeChoice{.keyframes = {20600ms}, .struck = {10200ms}});
}

TEST_CASE("no touch adds more moments than a choice may have") {
    KeyframeChoice full;
    for (std::size_t k = 0; k < max_moments_of_a_choice; ++k)
        full.struck.emplace_back(std::chrono::seconds(2 * k));
    KeyframeEdit edit(full);
    edit.touch_picture(1h);
    edit.touch_picture(9001s);
    CHECK(edit.choice().struck.size() <= max_moments_of_a_choice);
}
