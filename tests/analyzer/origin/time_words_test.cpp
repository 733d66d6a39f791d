#include "analyzer/origin/time_words.hpp"

#include <doctest/doctest.h>

using namespace vitrine::analyzer;
using namespace std::chrono_literals;

TEST_CASE("zones are read in all forms that cameras write") {
    CHECK(zone_named("+02:00") == 2h);
    CHECK(zone_named("-0330") == -(3h + 30min));
    CHECK(zone_named("Z") == 0min);
    for (const char* text : {"", "+2", "02:00", "+15:00", "+02:60", "   :  "})
        CHECK_FALSE(zone_named(text));
}
