#include "player/input/gestures.hpp"
#include "player/scene/acts/noted_touches.hpp"
#include "player/scene/acts/touch_json.hpp"

#include <doctest/doctest.h>

#include <deque>
#include <random>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

using Kind = Gesture::Kind;
using Kinds = std::vector<Kind>;
using Ns = std::chrono::nanoseconds;

constexpr Ns noon = 1'800'000'000s;  // shared time when both boxes start

/// Describes two boxes and the line between them: a follower tells its leader of touches.
struct Way {
    Ns frame = 40ms;      // of the follower
    Ns led_frame = 40ms;  // of the leader
    Ns off = 0s;          // shared time of the follower minus that of the leader
    Ns least_delay = 1ms;
    Ns most_delay = 30ms;
};

Contact contact(Contact::Kind kind, Ns time, Vec2 at = {100, 100}) {
    return {.kind = kind, .at = at, .time = time};
}

std::vector<Contact> tap(Ns time) {
    return {contact(Contact::Kind::down, time), contact(Contact::Kind::up, time + 100ms)};
}

/// The gestures that the leader sees in touches that end within ten seconds.
std::vector<Gesture> led(const std::vector<Contact>& made, const Way& way, std::mt19937& random) {
    std::uniform_int_distribution<std::int64_t> delay(way.least_delay.count(), way.most_delay.count());
    std::deque<std::pair<Ns, std::string>> sent;  // with the time at which it comes
    NotedTouches noted;
    std::size_t next = 0;
    for (Ns now = way.frame; now < 12s; now += way.frame) {
        for (; next < made.size() && made[next].time <= now; ++next)
            noted.note(made[next]);
        const std::vector<InputEvent> told = noted.take(now);
        if (told.empty()) continue;
        Ns comes = now + Ns(delay(random));
        if (!sent.empty()) comes = std::max(comes, sent.back().first);
        sent.emplace_back(comes, touches_to_json(told, {.now = now, .epoch = noon + way.off}));
    }
    Gestures gestures;
    std::vector<Gesture> seen;
    for (Ns now = way.led_frame; now < 14s; now += way.led_frame) {
        for (; !sent.empty() && sent.front().first <= now; sent.pop_front())
            for (InputEvent event : touches_from_json(sent.front().second, {.now = now, .epoch = noon})) {
                std::get<Contact>(event).is_told = true;
                gestures.handle_input(event, 7);
            }
        for (const Gesture& gesture : gestures.next_gestures(now))
            seen.push_back(gesture);
    }
    return seen;
}

Kinds kinds(const std::vector<Gesture>& gestures) {
    Kinds kinds;
    for (const Gesture& gesture : gestures)
        if (kinds.empty() || gesture.kind != Kind::drag || kinds.back() != Kind::drag)
            kinds.push_back(gesture.kind);
    return kinds;
}

}  // namespace

TEST_CASE("a tap and a hold on a follower are one on the leader, however slowly either draws") {
    std::mt19937 random(3);
    for (const Ns frame : {17ms, 40ms, 1000ms})
        for (const Ns led_frame : {17ms, 40ms, 1000ms})
            for (const Ns off : {0s, 70s, -70s})
                for (Ns begin = 1s; begin < 2s; begin += 90ms) {
                    if (off != 0s && led_frame == 1s) continue;  // then only the times of messages are known
                    CAPTURE(frame.count());
                    CAPTURE(led_frame.count());
                    CAPTURE(off.count());
                    CAPTURE(begin.count());
                    const Way way{.frame = frame, .led_frame = led_frame, .off = off};
                    CHECK(kinds(led(tap(begin), way, random)) == Kinds{Kind::tap});
                    CHECK(kinds(led({contact(Contact::Kind::down, begin),
                                     contact(Contact::Kind::up, begin + 1100ms)},
                                    way, random)) == Kinds{Kind::hold, Kind::release});
                }
}

TEST_CASE("a finger that stays on a follower holds after half a second and a frame, and not before") {
    std::mt19937 random(4);
    const Way way{.least_delay = 5ms, .most_delay = 5ms};
    const auto held = [&](Ns for_so_long) {
        return kinds(led({contact(Contact::Kind::down, 1s), contact(Contact::Kind::up, 1s + for_so_long)},
                         way, random));
    };
    CHECK(held(450ms) == Kinds{Kind::tap});
    CHECK(held(560ms) == Kinds{Kind::hold, Kind::release});
}

TEST_CASE("two taps on a slow follower are a double tap, and a flick keeps its speed") {
    std::mt19937 random(5);
    std::vector<Contact> twice = tap(1950ms);
    for (const Contact& second : tap(2200ms))
        twice.push_back(second);
    CHECK(kinds(led(twice, {.frame = 1s, .led_frame = 1s}, random)) ==
          Kinds{Kind::tap, Kind::tap, Kind::double_tap});
    std::vector<Contact> flick{contact(Contact::Kind::down, 1s)};
    for (int k = 1; k <= 30; ++k)
        flick.push_back(contact(Contact::Kind::move, 1s + k * 8ms, {100 + 8.0 * k, 100}));
    flick.push_back(contact(Contact::Kind::up, 1s + 248ms));
    for (int k = 0; k < 20; ++k) {
        const std::vector<Gesture> seen = led(flick, {.most_delay = 60ms}, random);
        CHECK(kinds(seen) == Kinds{Kind::drag, Kind::flick});
        CHECK(seen.back().velocity.x == doctest::Approx(1000).epsilon(0.01));
    }
}

TEST_CASE("a finger of which nothing more is heard neither holds nor taps, and is let go after a minute") {
    Gestures gestures;
    Contact down = contact(Contact::Kind::down, 1s);
    down.is_told = true;
    gestures.handle_input(down, 7);
    CHECK(gestures.next_gestures(60s).empty());
    CHECK(gestures.is_touched());
    CHECK(kinds(gestures.next_gestures(61s)).empty());
    CHECK_FALSE(gestures.is_touched());
}

TEST_CASE("a finger that rests is told for a minute, and one that moves or was lifted is not told twice") {
    NotedTouches touches;
    touches.note(contact(Contact::Kind::down, 1s));
    CHECK(touches.take(1010ms).size() == 1);
    const std::vector<InputEvent> rests = touches.take(1050ms);
    REQUIRE(rests.size() == 1);
    CHECK(std::get<Contact>(rests[0]) == contact(Contact::Kind::move, 1050ms));
    touches.note(contact(Contact::Kind::move, 1060ms, {130, 100}));
    CHECK(touches.take(1090ms) == std::vector<InputEvent>{contact(Contact::Kind::move, 1060ms, {130, 100})});
    CHECK(touches.take(60s).size() == 1);
    CHECK(touches.take(62s).empty());
    touches.note(contact(Contact::Kind::up, 63s));
    CHECK(touches.take(63s).size() == 1);
    CHECK(touches.take(64s).empty());
}

TEST_CASE("the end of a finger is told, however much it has moved since the last frame") {
    NotedTouches touches;
    touches.note(contact(Contact::Kind::down, 1s));
    for (int k = 1; k <= 1000; ++k)
        touches.note(contact(Contact::Kind::move, 1s + k * 40ms, {100.0 + k, 100}));
    touches.note(contact(Contact::Kind::up, 42s));
    const std::vector<InputEvent> told = touches.take(42s);
    CHECK(told.size() == 201);
    CHECK(std::get<Contact>(told.back()).kind == Contact::Kind::up);
    for (int k = 0; k < 2000; ++k)
        touches.note(KeyPress{.time = 43s});
    CHECK(touches.take(44s).size() == 400);
}
