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

TEST_CASE("one mode is meant for all outputs that are not named") {
    CHECK(modes_named("")->of("HDMI-A-1") == ModeWish{});
    CHECK(modes_named("1920x1080")->of("HDMI-A-1") == ModeWish{1920, 1080});
    CHECK(modes_named("1920x1080@59.94")->of("HDMI-A-1") == ModeWish{1920, 1080, 59.94});

    const auto some = modes_named("HDMI-A-1 = 1920x1080@60,HDMI-A-2=1280x720");
    REQUIRE(some);
    CHECK(some->of("HDMI-A-1") == ModeWish{1920, 1080, 60});
    CHECK(some->of("HDMI-A-2") == ModeWish{1280, 720});
    CHECK(some->of("DP-1") == ModeWish{});

    const auto rest = modes_named("HDMI-A-1=preferred, 800x600");
    REQUIRE(rest);
    CHECK(rest->of("HDMI-A-1") == ModeWish{});
    CHECK(rest->of("DP-1") == ModeWish{800, 600});
}

TEST_CASE("modes that are not understood, or given twice to an output or to all, are refused") {
    for (const char* text : {"1080p",
                             "1920",
                             "1920x",
                             "x1080",
                             "1920x1080@",
                             "1920x1080@0",
                             "1920x1080@60Hz",
                             "1920x1080@1e9",
                             "0x0",
                             "-1x5",
                             "1920.5x1080",
                             "1920x1080x5",
                             "99999x99999",
                             "HDMI-A-1=",
                             "=1920x1080",
                             "HDMI-A-1=1920",
                             "1920x1080,",
                             "1920x1080, 800x600",
                             "DP-1=1920x1080, DP-1=800x600",
                             "DP-1=1920x1080 DP-2=800x600"}) {
        CAPTURE(text);
        CHECK_FALSE(modes_named(text));
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

TEST_CASE("screens in memory have a size each") {
    CHECK(screen_sizes_named("1280x720") == std::vector<ScreenSize>{{1280, 720}});
    CHECK(screen_sizes_named("1280x720+640x360") == std::vector<ScreenSize>{{1280, 720}, {640, 360}});
    for (const char* text :
         {"", "1280", "1280x", "0x720", "-1x720", "1280x720x2", "99999x720", "64x32+", "+64x32"}) {
        CAPTURE(text);
        CHECK_FALSE(screen_sizes_named(text));
    }
}
