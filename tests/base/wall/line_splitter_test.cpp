#include "base/wall/line_connection.hpp"

#include "base/wall/broken_line.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

TEST_CASE("lines come whole, whatever the pieces are") {
    LineSplitter splitter(100);
    CHECK(splitter.push("on").empty());
    CHECK(splitter.push("e\ntwo\n\nth") == std::vector<std::string>{"one", "two", ""});
    CHECK(splitter.push("ree\n") == std::vector<std::string>{"three"});
}

TEST_CASE("a line may be as long as the limit and no longer, complete or not") {
    LineSplitter splitter(4);
    CHECK(splitter.push("1234\n") == std::vector<std::string>{"1234"});
    CHECK_THROWS_WITH_AS(splitter.push("12345"), "a line has more than 4 bytes", BrokenLine);
    LineSplitter other(4);
    CHECK(other.push("123").empty());
    CHECK_THROWS_AS(other.push("45\n"), BrokenLine);
}
