#include "player/input/rehearsal.hpp"

#include "player/input/gestures.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

std::vector<std::string> paths(const Rehearsal& rehearsal) {
    std::vector<std::string> paths;
    for (const char* path : {"a b.jpg", "c.jpg", "d.jpg"})
        if (rehearsal.is_present(path)) paths.emplace_back(path);
    return paths;
}

using Paths = std::vector<std::string>;

}  // namespace

TEST_CASE("files of a rehearsal come and go at their times, the others are always there") {
    Rehearsal rehearsal("# a comment\n\n5 remove c.jpg\n 2.5 add a b.jpg\n7 add c.jpg\n");
    CHECK(paths(rehearsal) == Paths{"c.jpg", "d.jpg"});
    CHECK_FALSE(rehearsal.advance(2400ms));
    CHECK(rehearsal.advance(2500ms));
    CHECK(paths(rehearsal) == Paths{"a b.jpg", "c.jpg", "d.jpg"});
    CHECK(rehearsal.advance(6s));
    CHECK(paths(rehearsal) == Paths{"a b.jpg", "d.jpg"});
    CHECK(rehearsal.advance(9s));
    CHECK(paths(rehearsal) == Paths{"a b.jpg", "c.jpg", "d.jpg"});
    CHECK_FALSE(rehearsal.advance(10s));
}

TEST_CASE("the finger of a rehearsal goes evenly from one place to the other, rests and is lifted") {
    Rehearsal rehearsal("4 drag 100 200 300 100 2\n");
    const auto contacts = [&](std::chrono::nanoseconds now) {
        rehearsal.advance(now);
        std::vector<Contact> since;
        for (const InputEvent& event : rehearsal.next_touches())
            since.push_back(std::get<Contact>(event));
        return since;
    };
    CHECK(contacts(3900ms).empty());
    const auto first = contacts(4s);
    REQUIRE(first.size() == 1);
    const int finger = first[0].finger;
    CHECK(first[0] == Contact{.finger = finger, .at = {100, 200}, .time = 4s});
    CHECK(contacts(5s).back() ==
          Contact{.kind = Contact::Kind::move, .finger = finger, .at = {200, 150}, .time = 5s});
    CHECK(contacts(6s).back().at == Vec2{300, 100});
    CHECK(contacts(6199ms).empty());
    CHECK(contacts(7s).back().kind == Contact::Kind::up);
    CHECK(contacts(9s).empty());
}

TEST_CASE("the words of a rehearsal are the gestures that are recognised") {
    const auto gestures_of = [](const std::string& script) {
        Rehearsal rehearsal(script);
        Gestures gestures;
        rehearsal.advance(20s);
        for (const InputEvent& event : rehearsal.next_touches())
            gestures.handle_input(event, 1);
        return gestures.next_gestures(20s);
    };
    using Kind = Gesture::Kind;
    CHECK(gestures_of("1 tap 5 6").back().kind == Kind::tap);
    CHECK(gestures_of("1 tap 5 6\n1.2 tap 5 6").back().kind == Kind::double_tap);
    CHECK(gestures_of("1 hold 5 6 1").front().kind == Kind::hold);
    CHECK(gestures_of("1 drag 5 6 300 6 1").back().kind == Kind::drop);
    CHECK(gestures_of("1 flick 5 6 300 6").back().kind == Kind::flick);
    CHECK(gestures_of("1 key back").back().key == Key::back);
    CHECK(gestures_of("1 wheel 5 6 -1").back().factor < 1);
    for (const double factor : {3.0, 0.5}) {
        double product = 1;
        for (const Gesture& gesture : gestures_of("1 pinch 300 200 " + std::to_string(factor) + " 0.5"))
            product *= gesture.factor;
        CHECK(product == doctest::Approx(factor));
    }
}

TEST_CASE("lines of a rehearsal at the same time are several hands, and a script may lose a finger") {
    Rehearsal rehearsal("1 drag 5 6 300 6 1\n1.2 drag 5 206 300 206 1\n1.4 down 3 700 300\n1.8 cancel 3\n");
    rehearsal.advance(20s);
    Gestures gestures;
    std::size_t most = 0;
    for (const InputEvent& event : rehearsal.next_touches()) {
        gestures.handle_input(event);
        most = std::max(most, gestures.count());
    }
    CHECK(most == 3);
    std::map<std::uint64_t, Gesture::Kind> ends;
    for (const Gesture& gesture : gestures.next_gestures(20s))
        ends[gesture.touch] = gesture.kind;
    CHECK(ends.size() == 2);
    CHECK(ends[1] == Gesture::Kind::drop);
    CHECK(ends[2] == Gesture::Kind::drop);
    Rehearsal other("1 undo\n");
    other.advance(2s);
    CHECK(std::get<KeyPress>(other.next_touches().at(0)).key == Key::undo);
}

TEST_CASE("a wrong line of a rehearsal is named with its number and what is wrong") {
    const auto fault = [](const std::string& script) {
        try {
            const Rehearsal rehearsal(script);
        } catch (const std::runtime_error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(fault("1 add a\n2 dance b\n") ==
          "line 2 of the rehearsal, '2 dance b': an event must be one of add, remove, tap, hold, drag, "
          "flick, pinch, wheel, down, move, up, cancel, key, undo, clock");
    CHECK(fault("add a\n").find("line 1") != std::string::npos);
    CHECK(fault("1 add\n").find("is missing") != std::string::npos);
    CHECK(fault("1 drag 1 2 3\n").find("X Y X Y SECONDS") != std::string::npos);
    CHECK(fault("1 up 100\n").find("from 0 to 99") != std::string::npos);
    CHECK(fault("-1 add a\n").find("from 0 to") != std::string::npos);
}

TEST_CASE("the clock of a rehearsal goes on from what it was set to") {
    Rehearsal rehearsal("1 clock 2026-12-24 17:59:50\n20 clock 2027-01-01 00:00:00\n");
    const auto day = [](int year, unsigned month, unsigned of_month) {
        return std::chrono::local_days(std::chrono::year(year) / std::chrono::month(month) /
                                       std::chrono::day(of_month));
    };
    CHECK_FALSE(rehearsal.local_time());
    rehearsal.advance(1500ms);
    CHECK(rehearsal.local_time() == day(2026, 12, 24) + 17h + 59min + 50s);
    rehearsal.advance(11s);
    CHECK(rehearsal.local_time() == day(2026, 12, 24) + 18h);
    rehearsal.advance(25s);
    CHECK(rehearsal.local_time() == day(2027, 1, 1) + 5s);
    CHECK_THROWS(Rehearsal("0 clock 2026-02-30 00:00:00\n"));
    CHECK_THROWS(Rehearsal("0 clock noon\n"));
}
