#include "base/system/log.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using log::Level;

TEST_CASE(
    "a line for the journal begins with its priority, one for a terminal with a word where it is not news") {
    CHECK(log::line_of(Level::error, "no card", true) == "<3>no card\n");
    CHECK(log::line_of(Level::debug, "tick", true) == "<7>tick\n");
    CHECK(log::line_of(Level::info, "12 files", false) == "12 files\n");
    CHECK(log::line_of(Level::warning, "slow", false) == "warning: slow\n");
}

TEST_CASE("a file name with a line break cannot forge a line") {
    CHECK(log::line_of(Level::info, "'a\n<3>b\x1b'", true) == "<6>'a\\x0a<3>b\\x1b'\n");
}

TEST_CASE("a line less important than the level is not wanted") {
    log::set_level(Level::warning);
    CHECK(log::is_wanted(Level::error));
    CHECK(log::is_wanted(Level::warning));
    CHECK_FALSE(log::is_wanted(Level::info));
    log::set_level(Level::info);
    CHECK(log::is_wanted(Level::info));
    CHECK_FALSE(log::is_wanted(Level::debug));
}
