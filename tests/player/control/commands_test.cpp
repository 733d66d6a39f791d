#include "player/control/commands.hpp"

#include <doctest/doctest.h>

using namespace vitrine::player;

namespace {

Command command_with(const char* result) {
    return {.name = "name",
            .help = "",
            .method = "Method",
            .arguments = "",
            .result = result,
            .done = "done",
            .undone = "undone"};
}

std::string line_of(const char* result, bool is_off, const std::string& text) {
    return answer_line(command_with(result), is_off, {.text = text, .pictures = {}});
}

}  // namespace

TEST_CASE("an answer that is a string is printed as it is") {
    CHECK(line_of("s", false, R"({"a":1})") == R"({"a":1})");
}

TEST_CASE("an answer that is a path is printed after the words for what was done") {
    CHECK(line_of("ay", false, "a.jpg") == "done: a.jpg");
    CHECK(line_of("ay", true, "a.jpg") == "undone: a.jpg");
}

TEST_CASE("nothing is printed for a command without an answer") {
    CHECK(line_of("", false, "").empty());
}
