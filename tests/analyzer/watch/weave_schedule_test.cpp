#include "analyzer/watch/weave_schedule.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::analyzer;
using Kind = WeaveAction::Kind;
using Actions = std::vector<WeaveAction>;

TEST_CASE("films are woven one at a time, the newest first, and only while nothing is analysed") {
    WeaveSchedule schedule;
    schedule.request_film("old", 1, 10);
    schedule.request_film("new", 1, 30);
    schedule.request_film("middle", 1, 20);
    CHECK(schedule.next_actions(false).empty());
    CHECK(schedule.next_actions(true) == Actions{{Kind::start, "new"}});
    CHECK(schedule.running_film() == "new");
    CHECK(schedule.next_actions(true).empty());
    schedule.finish_weaving("new", true);
    CHECK(schedule.next_actions(true) == Actions{{Kind::start, "middle"}});
    schedule.finish_weaving("middle", true);
    CHECK(schedule.next_actions(true) == Actions{{Kind::start, "old"}});
    CHECK_FALSE(schedule.is_idle());
    schedule.finish_weaving("old", true);
    CHECK(schedule.next_actions(true).empty());
    CHECK(schedule.is_idle());
}

TEST_CASE("a weaving stands still while something is analysed") {
    WeaveSchedule schedule;
    schedule.request_film("film", 1, 1);
    REQUIRE(schedule.next_actions(true).size() == 1);
    CHECK(schedule.next_actions(false) == Actions{{Kind::pause, "film"}});
    CHECK(schedule.next_actions(false).empty());
    CHECK(schedule.next_actions(true) == Actions{{Kind::go_on, "film"}});
    CHECK(schedule.next_actions(true).empty());
    REQUIRE(schedule.next_actions(false).size() == 1);
    schedule.finish_weaving("film", true);  // it was done before it stood
    schedule.request_film("next", 1, 1);
    CHECK(schedule.next_actions(true) == Actions{{Kind::start, "next"}});
}

TEST_CASE("the weaving of a film that goes is stopped, that of one that changes begins anew") {
    WeaveSchedule schedule;
    schedule.request_film("film", 1, 1);
    REQUIRE(schedule.next_actions(true).size() == 1);
    schedule.request_film("film", 1, 1);
    CHECK(schedule.next_actions(true).empty());
    schedule.request_film("film", 2, 1);
    CHECK(schedule.next_actions(false) == Actions{{Kind::stop, "film"}});
    CHECK(schedule.next_actions(true).empty());
    schedule.finish_weaving("film", true);  // the child wove the earlier content
    CHECK(schedule.next_actions(true) == Actions{{Kind::start, "film"}});
    schedule.forget_film("film");
    CHECK(schedule.next_actions(true) == Actions{{Kind::stop, "film"}});
    schedule.finish_weaving("film", false);
    CHECK(schedule.next_actions(true).empty());
    CHECK(schedule.is_idle());
}

TEST_CASE("what cannot be woven is tried twice, and again when it has changed") {
    WeaveSchedule schedule;
    schedule.request_film("bad", 1, 9);
    schedule.request_film("good", 1, 1);
    REQUIRE(schedule.next_actions(true) == Actions{{Kind::start, "bad"}});
    schedule.finish_weaving("bad", false);
    REQUIRE(schedule.next_actions(true) == Actions{{Kind::start, "bad"}});
    schedule.finish_weaving("bad", false);
    CHECK(schedule.next_actions(true) == Actions{{Kind::start, "good"}});
    schedule.finish_weaving("good", true);
    schedule.request_film("bad", 1, 9);
    CHECK(schedule.next_actions(true).empty());
    CHECK(schedule.is_idle());
    schedule.request_film("bad", 2, 9);
    CHECK(schedule.next_actions(true) == Actions{{Kind::start, "bad"}});
}
