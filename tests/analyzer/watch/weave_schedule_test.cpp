#include "analyzer/watch/weave_schedule.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace vitrine;
using namespace vitrine::analyzer;
using Kind = WeaveAction::Kind;
using Actions = std::vector<WeaveAction>;

TEST_CASE("films are woven one at a time, the newest first, and only while nothing is analysed") {
    WeaveSchedule schedule;
    schedule.request_film("old", 1, 10);
    schedule.request_film("new", 1, 30);
    schedule.request_film("middle", 1, 20);
    CHECK(schedule.next_actions(WeaveScope::wanted).empty());
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "new"}});
    CHECK(schedule.running_film() == "new");
    CHECK(schedule.next_actions(WeaveScope::all).empty());
    schedule.finish_weaving("new", true);
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "middle"}});
    schedule.finish_weaving("middle", true);
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "old"}});
    CHECK_FALSE(schedule.is_idle());
    schedule.finish_weaving("old", true);
    CHECK(schedule.next_actions(WeaveScope::all).empty());
    CHECK(schedule.is_idle());
}

TEST_CASE("a weaving stands still while something is analysed") {
    WeaveSchedule schedule;
    schedule.request_film("film", 1, 1);
    REQUIRE(schedule.next_actions(WeaveScope::all).size() == 1);
    CHECK(schedule.next_actions(WeaveScope::wanted) == Actions{{Kind::pause, "film"}});
    CHECK(schedule.next_actions(WeaveScope::wanted).empty());
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::go_on, "film"}});
    CHECK(schedule.next_actions(WeaveScope::all).empty());
    REQUIRE(schedule.next_actions(WeaveScope::wanted).size() == 1);
    schedule.finish_weaving("film", true);  // it was done before it stood
    schedule.request_film("next", 1, 1);
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "next"}});
}

TEST_CASE("the weaving of a film that goes is stopped, that of one that changes begins anew") {
    WeaveSchedule schedule;
    schedule.request_film("film", 1, 1);
    REQUIRE(schedule.next_actions(WeaveScope::all).size() == 1);
    schedule.request_film("film", 1, 1);
    CHECK(schedule.next_actions(WeaveScope::all).empty());
    schedule.request_film("film", 2, 1);
    CHECK(schedule.next_actions(WeaveScope::wanted) == Actions{{Kind::stop, "film"}});
    CHECK(schedule.next_actions(WeaveScope::all).empty());
    schedule.finish_weaving("film", true);  // the child wove the earlier content
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "film"}});
    schedule.forget_film("film");
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::stop, "film"}});
    schedule.finish_weaving("film", false);
    CHECK(schedule.next_actions(WeaveScope::all).empty());
    CHECK(schedule.is_idle());
}

TEST_CASE("films of chosen keyframes come first, and another choice begins anew") {
    WeaveSchedule schedule;
    schedule.request_film("new", 1, 30);
    schedule.request_film("chosen", 1, 10, "a");
    REQUIRE(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "chosen"}});
    schedule.request_film("chosen", 1, 10, "a");
    CHECK(schedule.next_actions(WeaveScope::all).empty());
    schedule.request_film("chosen", 1, 10, "b");
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::stop, "chosen"}});
    schedule.finish_weaving("chosen", true);
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "chosen"}});
    schedule.finish_weaving("chosen", true);
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "new"}});
}

TEST_CASE("what cannot be woven is tried twice, and again when it has changed") {
    WeaveSchedule schedule;
    schedule.request_film("bad", 1, 9);
    schedule.request_film("good", 1, 1);
    REQUIRE(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "bad"}});
    schedule.finish_weaving("bad", false);
    REQUIRE(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "bad"}});
    schedule.finish_weaving("bad", false);
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "good"}});
    schedule.finish_weaving("good", true);
    schedule.request_film("bad", 1, 9);
    CHECK(schedule.next_actions(WeaveScope::all).empty());
    CHECK(schedule.is_idle());
    schedule.request_film("bad", 2, 9);
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "bad"}});
}

TEST_CASE("the film that a visitor waits for comes before all others, also while something is analysed") {
    WeaveSchedule schedule;
    schedule.request_film("old", 1, 10);
    schedule.request_film("new", 1, 30);
    REQUIRE(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "new"}});
    schedule.want_film("old");
    CHECK(schedule.next_actions(WeaveScope::none) == Actions{{Kind::pause, "new"}});
    CHECK(schedule.next_actions(WeaveScope::wanted) == Actions{{Kind::stop, "new"}});
    CHECK(schedule.next_actions(WeaveScope::wanted).empty());
    schedule.finish_weaving("new", false);
    CHECK(schedule.next_actions(WeaveScope::wanted) == Actions{{Kind::start, "old"}});
    CHECK(schedule.next_actions(WeaveScope::wanted).empty());
    CHECK(schedule.next_actions(WeaveScope::all).empty());
    schedule.want_film("");  // the visitor has gone
    CHECK(schedule.next_actions(WeaveScope::wanted) == Actions{{Kind::pause, "old"}});
    schedule.want_film("old");
    CHECK(schedule.next_actions(WeaveScope::wanted) == Actions{{Kind::go_on, "old"}});
    schedule.finish_weaving("old", true);
    CHECK(schedule.next_actions(WeaveScope::wanted).empty());
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "new"}});
}

TEST_CASE("a weaving that gave way has not failed, however often it does") {
    WeaveSchedule schedule;
    schedule.request_film("long", 1, 30);
    for (int i = 0; i < 5; ++i) {
        const std::string visited = "visited " + std::to_string(i);
        schedule.want_film("");
        REQUIRE(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "long"}});
        schedule.request_film(visited, 1, 1);
        schedule.want_film(visited);
        REQUIRE(schedule.next_actions(WeaveScope::all) == Actions{{Kind::stop, "long"}});
        schedule.finish_weaving("long", false);
        REQUIRE(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, visited}});
        schedule.finish_weaving(visited, true);
    }
}

TEST_CASE("who waits for a film that cannot be woven, or is woven, keeps no other film waiting") {
    WeaveSchedule schedule;
    schedule.request_film("bad", 1, 1);
    schedule.request_film("good", 1, 9);
    schedule.want_film("bad");
    for (int i = 0; i < WeaveSchedule::max_tries; ++i) {
        REQUIRE(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "bad"}});
        schedule.finish_weaving("bad", false);
    }
    CHECK(schedule.next_actions(WeaveScope::all) == Actions{{Kind::start, "good"}});
    schedule.want_film("woven.mp4");
    CHECK(schedule.next_actions(WeaveScope::all).empty());
}
