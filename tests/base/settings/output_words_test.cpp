#include "base/settings/output_words.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

TEST_CASE("one margin is meant for all sides, four for left, top, right and bottom") {
    CHECK(margins_named("") == Margins{});
    CHECK(margins_named("24") == Margins{{24, 0}, {24, 0}, {24, 0}, {24, 0}});
    const auto shares = margins_named("2.5%");
    REQUIRE(shares);
    CHECK(shares->top.share == doctest::Approx(0.025));
    CHECK(shares->top.pixels == 0);
    CHECK(margins_named("1, 2,3 ,4") == Margins{{1, 0}, {2, 0}, {3, 0}, {4, 0}});
    CHECK(margins_named("0,10%,0,0")->top.share == doctest::Approx(0.1));
}

TEST_CASE("margins that are not understood, negative or leave hardly a picture are refused") {
    for (const char* text :
         {"x", "1,2", "1,2,3,4,5", "-1", "41%", "2001", "3px", "nan", "inf", "1,,2,3", "%"}) {
        CAPTURE(text);
        CHECK_FALSE(margins_named(text));
    }
}

TEST_CASE("outputs are given folders below the media folder") {
    using Folders = std::map<std::string, std::string>;
    CHECK(output_folders_named("") == Folders{});
    CHECK(output_folders_named(" HDMI-A-1 = lobby,HDMI-A-2=the hall/left ") ==
          Folders{{"HDMI-A-1", "lobby"}, {"HDMI-A-2", "the hall/left"}});
}

TEST_CASE("folders elsewhere, and outputs that are named twice, are refused") {
    for (const char* text :
         {"lobby", "=lobby", "HDMI-A-1=", "HDMI-A-1=/lobby", "HDMI-A-1=../x", "HDMI-A-1=a/../b",
          "HDMI-A-1=a/", "HDMI-A-1=a,HDMI-A-1=b", "HDMI-A-1=a,", "HDMI-A-1=."}) {
        CAPTURE(text);
        CHECK_FALSE(output_folders_named(text));
    }
}
