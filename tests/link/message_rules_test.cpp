#include "link/message_rules.hpp"

#include "base/wall/broken_line.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace vitrine;
using namespace vitrine::link;

namespace {

const WallPlace leader{.wall = "lobby", .box = "left", .is_leader = true};
const WallPlace follower{.wall = "lobby", .box = "right", .is_leader = false};

WallMessage act(const std::string& payload) {
    return {.topic = *wall_topic("act"), .payload = payload};
}

}  // namespace

TEST_CASE("followers hear the leader, the leader hears followers, and each hears of each box") {
    CHECK(text_of(received(follower, "vitrine/lobby/act", "{}").topic) == "act");
    CHECK(received(leader, "vitrine/lobby/ready/right", "{}").topic.box == "right");
    CHECK(received(leader, "vitrine/lobby/box/left", "{}").topic.box == "left");
    CHECK_THROWS_AS(received(leader, "vitrine/lobby/act", "{}"), BrokenLine);
    CHECK_THROWS_AS(received(follower, "vitrine/lobby/touch/left", "{}"), BrokenLine);
}

TEST_CASE("a topic of another shape or another wall is refused") {
    for (const char* topic :
         {"vitrine/hall/act", "vitrine/lobby/acts", "vitrine/lobby/link", "vitrine/lobby/box/a/b",
          "vitrine/lobby/box/a b", "vitrine/lobby/", "", "lobby/act"})
        CHECK_THROWS_AS_MESSAGE(received(follower, topic, "{}"), BrokenLine, topic);
}

TEST_CASE("a payload has at most a MiB") {
    CHECK_NOTHROW(received(follower, "vitrine/lobby/act", std::string(max_wall_line, ' ')));
    CHECK_THROWS_AS(received(follower, "vitrine/lobby/act", std::string(max_wall_line + 1, ' ')), BrokenLine);
}

TEST_CASE("an act of another version is a sentence with both versions") {
    CHECK(checked(act(R"({"version":1})")).payload == R"({"version":1})");
    CHECK_THROWS_WITH(
        checked(act(R"({"version":2})")),
        "the leader speaks version 2 of Vitrine's acts and this box version 1: both need the same package");
    for (const char* payload : {"{}", R"({"version":"1"})", R"({"version":-1})", R"({"version":1e300})",
                                R"({"version":18446744073709551615})"})
        CHECK_THROWS_AS_MESSAGE(checked(act(payload)), BrokenLine, payload);
}

TEST_CASE("what boxes say needs no version") {
    CHECK(checked({.topic = *wall_topic("box/left"), .payload = R"({"gone": true})"}).payload ==
          R"({"gone":true})");
}

TEST_CASE("a player sends what its box may send, and under its own name") {
    CHECK_NOTHROW(check_sent(leader, act("{}")));
    CHECK_NOTHROW(check_sent(leader, {.topic = *wall_topic("box/left"), .payload = "{}"}));
    CHECK_NOTHROW(check_sent(follower, {.topic = *wall_topic("touch/right"), .payload = "{}"}));
    CHECK_THROWS_AS(check_sent(follower, act("{}")), BrokenLine);
    CHECK_THROWS_AS(check_sent(leader, {.topic = *wall_topic("ready/left"), .payload = "{}"}), BrokenLine);
    CHECK_THROWS_AS(check_sent(follower, {.topic = *wall_topic("box/left"), .payload = "{}"}), BrokenLine);
    CHECK_THROWS_AS(check_sent(leader, {.topic = *wall_topic("link"), .payload = "{}"}), BrokenLine);
}

TEST_CASE("a box subscribes to what it hears") {
    for (const WallPlace& place : {leader, follower})
        for (const std::string& topic : subscriptions_of(place)) {
            std::string one = topic;
            if (one.ends_with('+')) one.replace(one.size() - 1, 1, "other");
            CHECK_NOTHROW(received(place, one, "{}"));
        }
    CHECK(broker_topic(leader, *wall_topic("box/left")) == "vitrine/lobby/box/left");
}
