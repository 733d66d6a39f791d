#include "player/display/kms_state.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace vitrine;

namespace {

drmModeModeInfo mode(int width, int height, int rate, bool is_preferred = false) {
    drmModeModeInfo made{};
    made.hdisplay = static_cast<std::uint16_t>(width);
    made.vdisplay = static_cast<std::uint16_t>(height);
    made.vrefresh = static_cast<std::uint32_t>(rate);
    made.type = is_preferred ? DRM_MODE_TYPE_PREFERRED : 0;
    return made;
}

// One connector without and one with a panel, each of which the two CRTCs can feed.
CardState card() {
    CardState made;
    made.crtcs = {40, 41};
    made.planes = {{.id = 30, .crtcs = 0b01, .is_primary = true},
                   {.id = 31, .crtcs = 0b11, .is_primary = false},
                   {.id = 32, .crtcs = 0b10, .is_primary = true}};
    made.connectors = {{.id = 50, .name = "HDMI-A-1", .crtcs = 0b11},
                       {.id = 51, .name = "HDMI-A-2", .is_connected = true, .crtcs = 0b11}};
    made.connectors[1].modes = {mode(3840, 2160, 30), mode(1920, 1080, 60, true), mode(1920, 1080, 50),
                                mode(1280, 720, 60)};
    return made;
}

}  // namespace

TEST_CASE("the first panel is shown on in the mode it prefers") {
    const auto output = choose_output(card(), {}, true);

    REQUIRE(output);
    CHECK(output->connector == 51);
    CHECK(output->crtc == 40);
    CHECK(output->plane == 30);
    CHECK(output->name == "HDMI-A-2");
    CHECK(output->mode.hdisplay == 1920);
    CHECK(output->mode.vrefresh == 60);
}

TEST_CASE("the CRTC that feeds a panel already is kept, with its own primary plane") {
    CardState state = card();
    state.connectors[1].crtc_id = 41;

    const auto output = choose_output(state, {}, true);

    REQUIRE(output);
    CHECK(output->crtc == 41);
    CHECK(output->plane == 32);
}

TEST_CASE("the mode that is wished for is chosen") {
    const auto of_size = choose_output(card(), parse_mode("1280x720"), true);
    const auto of_rate = choose_output(card(), parse_mode("1920x1080@50"), true);

    REQUIRE(of_size);
    CHECK(of_size->mode.hdisplay == 1280);
    REQUIRE(of_rate);
    CHECK(of_rate->mode.vrefresh == 50);
}

TEST_CASE("of one size the fastest mode is chosen, 59.94 Hz is meant by 60, and interlaced never") {
    CardState state = card();
    drmModeModeInfo ntsc = mode(1280, 720, 60);
    ntsc.clock = 74176;  // kHz: 59.94 Hz
    ntsc.htotal = 1650;
    ntsc.vtotal = 750;
    drmModeModeInfo interlaced = mode(1280, 720, 120);
    interlaced.flags = DRM_MODE_FLAG_INTERLACE;
    state.connectors[1].modes = {mode(1280, 720, 50), ntsc, interlaced};

    const auto fastest = choose_output(state, parse_mode("1280x720"), true);
    const auto sixty = choose_output(state, parse_mode("1280x720@60"), true);

    REQUIRE(fastest);
    CHECK(fastest->mode.clock == 74176);
    REQUIRE(sixty);
    CHECK(sixty->mode.clock == 74176);
    CHECK(refresh_rate(sixty->mode) == doctest::Approx(59.94).epsilon(0.0001));
}

TEST_CASE("a mode that the panel lacks gives way to the one it prefers, and without one to its first") {
    CardState state = card();
    const auto output = choose_output(state, parse_mode("800x600"), true);
    REQUIRE(output);
    CHECK(output->mode.hdisplay == 1920);

    for (drmModeModeInfo& each : state.connectors[1].modes)
        each.type = 0;
    CHECK(choose_output(state, {}, true)->mode.hdisplay == 3840);
}

TEST_CASE("without a panel, a way to it or its plane there is no output") {
    CardState dark = card();
    dark.connectors[1].is_connected = false;
    CHECK_FALSE(choose_output(dark, {}, true));

    CardState unreachable = card();
    unreachable.connectors[1].crtcs = 0;
    CHECK_FALSE(choose_output(unreachable, {}, true));

    CardState planeless = card();
    planeless.planes.clear();
    CHECK_FALSE(choose_output(planeless, {}, true));
    CHECK(choose_output(planeless, {}, false));

    CHECK_FALSE(choose_output(card(), {.connector = "DP-1"}, true));
    CHECK_FALSE(choose_output(CardState{}, {}, true));
}

TEST_CASE("an output is another one when its timing changes, not when its marks do") {
    const Output one = *choose_output(card(), {}, true);
    Output other = one;
    CHECK(one.is_same(other));

    other.mode.type = 0;
    CHECK(one.is_same(other));
    other.mode.clock = 74250;
    CHECK_FALSE(one.is_same(other));
}

TEST_CASE("a mode that is not understood is refused") {
    for (const char* text : {"1080p", "1920", "1920x", "1920x1080@", "1920x1080@0", "1920x1080@60Hz", "0x0",
                             "-1x5", "1920x1080 "}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_mode(text), std::invalid_argument);
    }
    CHECK(parse_mode("").width == 0);
    CHECK(parse_mode("preferred").width == 0);
    CHECK(parse_mode("1920x1080@59.94").refresh_rate == doctest::Approx(59.94));
}
