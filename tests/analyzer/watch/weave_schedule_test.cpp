#include "analyzer/watch/weave_schedule.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::analyzer;
using Kind = WeaveAction::Kind;
using Actions = std::vector<WeaveAction>;

TEST_CASE("films are woven one at a time, the newest first, and only while nothing is analysed") {
    WeaveSchedule schedule;
    schedule.want("old", 1, 10);
    schedule.want("new", 1, 30);
    schedule.want("middle", 1, 20);
    CHECK(schedule.step(false).empty());
    CHECK(schedule.step(true) == Actions{{Kind::start, "new"}});
    CHECK(schedule.running() == "new");
    CHECK(schedule.step(true).empty());
    schedule.finished("new", true);
    CHECK(schedule.step(true) == Actions{{Kind::start, "middle"}});
    schedule.finished("middle", true);
    CHECK(schedule.step(true) == Actions{{Kind::start, "old"}});
    CHECK_FALSE(schedule.is_idle());
    schedule.finished("old", true);
    CHECK(schedule.step(true).empty());
    CHECK(schedule.is_idle());
}

TEST_CASE("a weaving stands still while something is analysed") {
    WeaveSchedule schedule;
    schedule.want("film", 1, 1);
    REQUIRE(schedule.step(true).size() == 1);
    CHECK(schedule.step(false) == Actions{{Kind::pause, "film"}});
    CHECK(schedule.step(false).empty());
    CHECK(schedule.step(true) == Actions{{Kind::go_on, "film"}});
    CHECK(schedule.step(true).empty());
    REQUIRE(schedule.step(false).size() == 1);
    schedule.finished("film", true);  // it was done before it stood
    schedule.want("next", 1, 1);
    CHECK(schedule.step(true) == Actions{{Kind::start, "next"}});
}

TEST_CASE("the weaving of a film that goes is stopped, that of one that changes begins anew") {
    WeaveSchedule schedule;
    schedule.want("film", 1, 1);
    REQUIRE(schedule.step(true).size() == 1);
    schedule.want("film", 1, 1);
    CHECK(schedule.step(true).empty());
    schedule.want("film", 2, 1);
    CHECK(schedule.step(false) == Actions{{Kind::stop, "film"}});
    CHECK(schedule.step(true).empty());
    schedule.finished("film", true);  // of what it was before
    CHECK(schedule.step(true) == Actions{{Kind::start, "film"}});
    schedule.forget("film");
    CHECK(schedule.step(true) == Actions{{Kind::stop, "film"}});
    schedule.finished("film", false);
    CHECK(schedule.step(true).empty());
    CHECK(schedule.is_idle());
}

TEST_CASE("what cannot be woven is tried twice, and again when it has changed") {
    WeaveSchedule schedule;
    schedule.want("bad", 1, 9);
    schedule.want("good", 1, 1);
    REQUIRE(schedule.step(true) == Actions{{Kind::start, "bad"}});
    schedule.finished("bad", false);
    REQUIRE(schedule.step(true) == Actions{{Kind::start, "bad"}});
    schedule.finished("bad", false);
    CHECK(schedule.step(true) == Actions{{Kind::start, "good"}});
    schedule.finished("good", true);
    schedule.want("bad", 1, 9);
    CHECK(schedule.step(true).empty());
    CHECK(schedule.is_idle());
    schedule.want("bad", 2, 9);
    CHECK(schedule.step(true) == Actions{{Kind::start, "bad"}});
}
