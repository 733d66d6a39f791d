#include "base/wall/wall_message.hpp"

#include "base/wall/broken_line.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace vitrine;

namespace {

std::string nested(int levels) {
    return R"({"topic":"act","payload":{"a":)" + std::string(static_cast<std::size_t>(levels), '[') +
           std::string(static_cast<std::size_t>(levels), ']') + "}}";
}

}  // namespace

TEST_CASE("a message is read as it is written, doubles exactly") {
    const WallMessage sent{.topic = *wall_topic("ready/left"),
                           .is_retained = true,
                           .payload = R"({"x":0.1,"y":1.7976931348623157e+308,"name":"ä \" \n"})"};
    const WallMessage got = wall_message(line_of(sent));
    CHECK(text_of(got.topic) == "ready/left");
    CHECK(got.is_retained);
    CHECK(got.payload == sent.payload);
    CHECK(line_of(sent).find('\n') == std::string::npos);
    CHECK(line_of(sent).find(R"("box":"left")") != std::string::npos);
}

TEST_CASE("a message needs no word on being kept") {
    CHECK_FALSE(wall_message(R"({"topic":"act","payload":{}})").is_retained);
}

TEST_CASE("a line that is no message is refused with a sentence") {
    for (const char* line :
         {"", "x", "[]", "7", "{}", R"({"topic":"act"})", R"({"payload":{}})", R"({"topic":7,"payload":{}})",
          R"({"topic":"acts","payload":{}})", R"({"topic":"act","payload":[]})",
          R"({"topic":"act","payload":"{}"})", R"({"topic":"act","retain":"yes","payload":{}})",
          R"({"topic":"act","payload":{}} {})", R"({"topic":"act","payload":{"a":1e999}})",
          "{\"topic\":\"act\",\"payload\":{\"a\":\"\xff\"}}", R"({"topic":"act","payload":{"a":NaN}})",
          R"({"topic":"box/a/b","payload":{}})"})
        CHECK_THROWS_AS_MESSAGE(wall_message(line), BrokenLine, line);
}

TEST_CASE("levels and bytes of a message are bounded") {
    CHECK_NOTHROW(wall_message(nested(29)));
    CHECK_THROWS_AS(wall_message(nested(33)), BrokenLine);
    CHECK_THROWS_AS(wall_message(nested(200000)), BrokenLine);
    const std::string text(max_wall_line, ' ');
    CHECK_THROWS_AS(wall_message("{\"topic\":\"act\",\"payload\":{}}" + text), BrokenLine);
}

TEST_CASE("a payload from outside is written anew in one line") {
    CHECK(checked_payload("{ \"version\" :\n 1 }") == R"({"version":1})");
    CHECK_THROWS_AS(checked_payload("[1]"), BrokenLine);
}

TEST_CASE("the state of the link tells what it was given") {
    const LinkState state = link_state(link_payload(true, "connected to 10.0.0.1"));
    CHECK(state.is_connected);
    CHECK(state.says == "connected to 10.0.0.1");
    CHECK_THROWS_AS(link_state("{}"), BrokenLine);
    CHECK_NOTHROW(link_state(link_payload(false, "a name of \xff bytes")));
}
