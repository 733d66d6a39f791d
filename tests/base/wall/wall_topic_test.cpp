#include "base/wall/wall_topic.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

TEST_CASE("each topic is read as it is written") {
    for (const char* text : {"act", "prepare", "lifted", "ready/left", "touch/left", "box/left", "link"}) {
        const auto topic = wall_topic(text);
        REQUIRE_MESSAGE(topic, text);
        CHECK(text_of(*topic) == text);
    }
    CHECK(wall_topic("ready/left")->box == "left");
    CHECK(wall_topic("act")->box.empty());
}

TEST_CASE("a text of another shape is no topic") {
    for (const char* text : {"", "acts", "act/left", "act/", "ready", "ready/", "ready/a/b", "ready/+",
                             "box/#", "/act", "link/x", "$SYS/broker"})
        CHECK_MESSAGE(!wall_topic(text), text);
}

TEST_CASE("acts and what they need come from the leader alone") {
    CHECK(is_of_leader(WallTopic::Kind::act));
    CHECK(is_of_leader(WallTopic::Kind::prepare));
    CHECK_FALSE(is_of_leader(WallTopic::Kind::box));
}
