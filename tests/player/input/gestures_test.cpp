#include "player/input/gestures.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

using Kind = Gesture::Kind;

Contact down(int finger, Vec2 at, std::chrono::nanoseconds time) {
    return {.kind = Contact::Kind::down, .finger = finger, .at = at, .time = time};
}

Contact move(int finger, Vec2 at, std::chrono::nanoseconds time) {
    return {.kind = Contact::Kind::move, .finger = finger, .at = at, .time = time};
}

Contact up(int finger, std::chrono::nanoseconds time) {
    return {.kind = Contact::Kind::up, .finger = finger, .time = time};
}

std::vector<Gesture> meant(const std::vector<InputEvent>& events, std::chrono::nanoseconds now,
                           Gestures gestures = Gestures()) {
    constexpr Subject shot = 7;
    for (const InputEvent& event : events)
        gestures.handle_input(event, shot);
    return gestures.next_gestures(now);
}

/// The kinds of one touch's gestures, those in a row only once.
std::vector<Kind> course_of(const std::vector<Gesture>& gestures, std::uint64_t touch) {
    std::vector<Kind> course;
    for (const Gesture& gesture : gestures)
        if (gesture.touch == touch && (course.empty() || course.back() != gesture.kind))
            course.push_back(gesture.kind);
    return course;
}

std::vector<Kind> kinds(const std::vector<Gesture>& gestures) {
    std::vector<Kind> kinds;
    kinds.reserve(gestures.size());
    for (const Gesture& gesture : gestures)
        kinds.push_back(gesture.kind);
    return kinds;
}

using Kinds = std::vector<Kind>;

}  // namespace

TEST_CASE("a finger that comes down and is lifted taps, though it trembles") {
    const auto gestures = meant({down(0, {100, 50}, 1s), move(0, {104, 53}, 1050ms), up(0, 1100ms)}, 1100ms);
    REQUIRE(kinds(gestures) == Kinds{Kind::tap});
    CHECK(gestures[0].at == Vec2{104, 53});
}

TEST_CASE("two taps at one place are two and a double tap; far apart, in place or time, only two") {
    const auto twice = [](Vec2 second, std::chrono::nanoseconds time) {
        return kinds(meant({down(0, {100, 50}, 1s), up(0, 1080ms), down(0, second, time), up(0, time + 80ms)},
                           time + 80ms));
    };
    CHECK(twice({110, 55}, 1300ms) == Kinds{Kind::tap, Kind::tap, Kind::double_tap});
    CHECK(twice({300, 55}, 1300ms) == Kinds{Kind::tap, Kind::tap});
    CHECK(twice({110, 55}, 1900ms) == Kinds{Kind::tap, Kind::tap});
}

TEST_CASE("three taps are one double tap") {
    const auto gestures = meant({down(0, {9, 9}, 0ms), up(0, 50ms), down(0, {9, 9}, 150ms), up(0, 200ms),
                                 down(0, {9, 9}, 300ms), up(0, 350ms)},
                                350ms);
    CHECK(kinds(gestures) == Kinds{Kind::tap, Kind::tap, Kind::double_tap, Kind::tap});
}

TEST_CASE("a finger that stays holds after half a second, and not before") {
    Gestures gestures;
    gestures.handle_input(down(0, {100, 50}, 1s));
    CHECK(gestures.next_gestures(1499ms).empty());
    CHECK(kinds(gestures.next_gestures(1500ms)) == Kinds{Kind::hold});
    CHECK(gestures.next_gestures(3s).empty());
    gestures.handle_input(up(0, 4s));
    CHECK(kinds(gestures.next_gestures(4s)) == Kinds{Kind::release});
}

TEST_CASE("a finger that moves drags from where it came down, and drops where it rests") {
    const auto gestures = meant({down(0, {100, 50}, 1s), move(0, {108, 50}, 1020ms),
                                 move(0, {130, 50}, 1040ms), move(0, {200, 80}, 1100ms), up(0, 2s)},
                                2s);
    REQUIRE(kinds(gestures) == Kinds{Kind::drag, Kind::drag, Kind::drop});
    CHECK(gestures[0].from == Vec2{100, 50});
    CHECK(gestures[0].moved == Vec2{30, 0});
    CHECK(gestures[1].moved == Vec2{70, 30});
    CHECK(gestures[2].at == Vec2{200, 80});
}

TEST_CASE("a finger lifted at speed flicks, with the speed of its last moment") {
    std::vector<InputEvent> events{down(0, {100, 50}, 0ms), move(0, {100, 300}, 500ms)};
    for (int k = 1; k <= 10; ++k)
        events.emplace_back(move(0, {100.0 + 20 * k, 300}, 500ms + k * 10ms));
    events.emplace_back(up(0, 602ms));
    const auto gestures = meant(events, 602ms);
    REQUIRE(gestures.back().kind == Kind::flick);
    CHECK(gestures.back().velocity.x == doctest::Approx(2000).epsilon(0.02));
    CHECK(gestures.back().velocity.y == doctest::Approx(0));
}

TEST_CASE("a contact that the panel takes back neither taps nor flicks") {
    CHECK(meant({down(0, {1, 1}, 0ms), Contact{.kind = Contact::Kind::cancel, .time = 50ms}}, 50ms).empty());
    const auto gestures = meant(
        {down(0, {0, 0}, 0ms), move(0, {90, 0}, 30ms), Contact{.kind = Contact::Kind::cancel, .time = 40ms}},
        40ms);
    CHECK(kinds(gestures) == Kinds{Kind::drag, Kind::lost});
}

TEST_CASE("two fingers pinch about their middle by how far they part") {
    const auto gestures =
        meant({down(0, {100, 100}, 0ms), down(1, {200, 100}, 20ms), move(0, {80, 100}, 40ms),
               move(1, {240, 120}, 60ms), up(0, 80ms), move(1, {245, 122}, 100ms), up(1, 120ms)},
              120ms);
    REQUIRE(kinds(gestures) == Kinds{Kind::pinch, Kind::pinch, Kind::pinch_end});
    CHECK(gestures[0].factor * gestures[1].factor == doctest::Approx(std::hypot(160, 20) / 100));
    CHECK(gestures[0].at == Vec2{140, 100});
    CHECK(gestures[0].moved + gestures[1].moved == Vec2{10, 10});
}

TEST_CASE("a drag that a second finger joins is dropped before the pinch; a third finger is nothing") {
    const auto gestures =
        meant({down(0, {100, 100}, 0ms), move(0, {150, 100}, 20ms), down(1, {250, 100}, 30ms),
               down(2, {400, 400}, 35ms), move(2, {500, 400}, 40ms), move(1, {300, 100}, 50ms), up(2, 60ms)},
              60ms);
    REQUIRE(kinds(gestures) == Kinds{Kind::drag, Kind::drop, Kind::pinch});
    CHECK(gestures[2].factor == doctest::Approx(1.5));
}

TEST_CASE("a notch of the wheel is a step of size at the pointer, back and forth the same") {
    const auto gestures = meant({Wheel{.notches = 1, .at = {5, 6}}, Wheel{.notches = -1, .at = {5, 6}}}, 0s);
    REQUIRE(kinds(gestures) == Kinds{Kind::wheel, Kind::wheel});
    CHECK(gestures[0].factor > 1);
    CHECK(gestures[0].factor * gestures[1].factor == doctest::Approx(1));
    CHECK(gestures[0].at == Vec2{5, 6});
}

TEST_CASE("a key is a gesture of its own") {
    const auto gestures = meant({KeyPress{.key = Key::back}}, 0s);
    REQUIRE(kinds(gestures) == Kinds{Kind::key});
    CHECK(gestures[0].key == Key::back);
}

TEST_CASE("a larger canvas allows more trembling") {
    const std::vector<InputEvent> events{down(0, {0, 0}, 0ms), move(0, {25, 0}, 20ms), up(0, 300ms)};
    CHECK(kinds(meant(events, 300ms, Gestures(gesture_rules({640, 360})))).front() == Kind::drag);
    CHECK(kinds(meant(events, 300ms, Gestures(gesture_rules({3840, 2160})))) == Kinds{Kind::tap});
}

TEST_CASE("ten contacts on ten subjects are ten drags, each with its own number; an eleventh is nothing") {
    Gestures gestures;
    for (int k = 0; k <= 10; ++k)
        gestures.handle_input(down(k, {100.0 * k, 50}, 1s + k * 1ms), static_cast<Subject>(k + 1));
    for (int k = 0; k <= 10; ++k)
        gestures.handle_input(move(k, {100.0 * k, 90}, 1100ms + k * 1ms));
    CHECK(gestures.count() == 10);
    for (int k = 0; k <= 10; ++k)
        gestures.handle_input(up(k, 2s));
    const auto all = gestures.next_gestures(2s);
    REQUIRE(all.size() == 20);
    for (std::uint64_t k = 1; k <= 10; ++k) {
        CHECK(course_of(all, k) == Kinds{Kind::drag, Kind::drop});
        CHECK(all[k - 1].subject == k);
    }
    CHECK_FALSE(gestures.is_touched());
}

TEST_CASE("two contacts beside all subjects are no pinch: each is a touch of its own") {
    Gestures gestures;
    for (const int k : {0, 1})
        gestures.handle_input(down(k, {100.0 + 50 * k, 50}, 1s), no_subject);
    for (const int k : {0, 1})
        gestures.handle_input(move(k, {100.0 + 50 * k, 150}, 1100ms));
    CHECK(kinds(gestures.next_gestures(1100ms)) == Kinds{Kind::drag, Kind::drag});
}

TEST_CASE("a contact that joins on another shot changes nothing for the first one") {
    Gestures gestures;
    gestures.handle_input(down(0, {100, 100}, 0ms), 1);
    gestures.handle_input(move(0, {150, 100}, 20ms));
    gestures.handle_input(down(1, {400, 100}, 30ms), 2);
    gestures.handle_input(move(0, {200, 100}, 40ms));
    gestures.handle_input(up(1, 90ms));
    gestures.handle_input(move(0, {250, 100}, 100ms));
    gestures.handle_input(up(0, 900ms));
    const auto all = gestures.next_gestures(900ms);
    CHECK(kinds(all) == Kinds{Kind::drag, Kind::drag, Kind::tap, Kind::drag, Kind::drop});
}

TEST_CASE("of two fingers that pinched, the one that stays may drag on") {
    const auto gestures =
        meant({down(0, {100, 100}, 0ms), down(1, {200, 100}, 20ms), move(1, {260, 100}, 40ms), up(0, 80ms),
               move(1, {300, 100}, 100ms), up(1, 900ms)},
              900ms);
    REQUIRE(kinds(gestures) == Kinds{Kind::pinch, Kind::pinch_end, Kind::drag, Kind::drop});
    CHECK(gestures[2].from == Vec2{260, 100});
}

TEST_CASE("a contact that rests for a minute is lost, and makes nobody else deaf") {
    Gestures gestures;
    gestures.handle_input(down(0, {100, 100}, 0s), 1);
    gestures.handle_input(move(0, {103, 100}, 30s));  // it trembles
    CHECK(kinds(gestures.next_gestures(59s)) == Kinds{Kind::hold});
    CHECK(gestures.is_touched());
    CHECK(kinds(gestures.next_gestures(60s)) == Kinds{Kind::lost});
    CHECK_FALSE(gestures.is_touched());
    gestures.handle_input(move(0, {300, 100}, 61s));  // it is ignored until it is lifted
    gestures.handle_input(down(1, {110, 100}, 62s), 1);
    gestures.handle_input(up(1, 62100ms));
    CHECK(kinds(gestures.next_gestures(63s)) == Kinds{Kind::tap});
    gestures.handle_input(up(0, 64s));
    gestures.handle_input(down(0, {100, 100}, 65s), 1);
    gestures.handle_input(up(0, 65100ms));
    CHECK(kinds(gestures.next_gestures(66s)) == Kinds{Kind::tap});
}

TEST_CASE("a contact that comes down a second time was lost in between") {
    const auto gestures =
        meant({down(0, {100, 100}, 0ms), move(0, {200, 100}, 50ms), down(0, {400, 100}, 100ms), up(0, 150ms)},
              150ms);
    CHECK(kinds(gestures) == Kinds{Kind::drag, Kind::lost, Kind::tap});
    CHECK(gestures[2].touch != gestures[0].touch);
}

TEST_CASE("two people who tap two shots in turn tap twice each, and double-tap only where one did") {
    Gestures gestures;
    const auto tap = [&](Vec2 at, Subject subject, std::chrono::nanoseconds time) {
        gestures.handle_input(down(0, at, time), subject);
        gestures.handle_input(up(0, time + 50ms));
    };
    tap({100, 100}, 1, 0ms);
    tap({500, 100}, 2, 100ms);
    tap({100, 100}, 1, 250ms);
    CHECK(kinds(gestures.next_gestures(1s)) == Kinds{Kind::tap, Kind::tap, Kind::tap, Kind::double_tap});
}
