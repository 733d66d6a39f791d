#include "player/display/kms_state.hpp"

#include <doctest/doctest.h>
#include <xf86drm.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;

namespace {

drmModeModeInfo mode(int width, int height, int rate, bool is_preferred = false) {
    drmModeModeInfo made{};
    made.hdisplay = static_cast<std::uint16_t>(width);
    made.vdisplay = static_cast<std::uint16_t>(height);
    made.vrefresh = static_cast<std::uint32_t>(rate);
    made.clock = static_cast<std::uint32_t>(width * height * rate / 1000);  // kHz, without blanking
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

ModeWishes modes(const char* words) {
    return modes_named(words).value();
}

// The output of a card with one panel.
std::optional<Output> choose_output(const CardState& state, const ModeWishes& wish, bool needs_plane) {
    const std::vector<Output> outputs = choose_outputs(state, wish, needs_plane);
    REQUIRE(outputs.size() <= 1);
    return outputs.empty() ? std::nullopt : std::optional(outputs.front());
}

// The card with panels at both connectors.
CardState two_panels() {
    CardState made = card();
    made.connectors[0].is_connected = true;
    made.connectors[0].modes = {mode(1280, 1024, 60, true)};
    return made;
}

std::uint32_t crtc_of(const std::vector<Output>& outputs, std::uint32_t connector) {
    const auto found = std::ranges::find(outputs, connector, &Output::connector);
    REQUIRE(found != outputs.end());
    return found->crtc;
}

}  // namespace

TEST_CASE("a panel is shown on in the mode it prefers") {
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
    const auto of_size = choose_output(card(), modes("1280x720"), true);
    const auto of_rate = choose_output(card(), modes("1920x1080@50"), true);

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

    const auto fastest = choose_output(state, modes("1280x720"), true);
    const auto sixty = choose_output(state, modes("1280x720@60"), true);

    REQUIRE(fastest);
    CHECK(fastest->mode.clock == 74176);
    REQUIRE(sixty);
    CHECK(sixty->mode.clock == 74176);
    CHECK(refresh_rate(sixty->mode) == doctest::Approx(59.94).epsilon(0.0001));
}

TEST_CASE("a mode that the panel lacks gives way to the one it prefers, and without one to its first") {
    CardState state = card();
    const auto output = choose_output(state, modes("800x600"), true);
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

    CardState mute = card();
    mute.connectors[1].modes.clear();
    CHECK_FALSE(choose_output(mute, {}, true));
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

    Output another_panel = one;
    another_panel.panel = 5;
    CHECK_FALSE(one.is_same(another_panel));
}

TEST_CASE("every panel is lit, each in its own mode and by a CRTC and a plane of its own") {
    const std::vector<Output> outputs = choose_outputs(two_panels(), {}, true);

    REQUIRE(outputs.size() == 2);
    CHECK(outputs[0].name == "HDMI-A-1");
    CHECK(outputs[0].mode.hdisplay == 1280);
    CHECK(outputs[1].mode.hdisplay == 1920);
    CHECK(outputs[0].crtc != outputs[1].crtc);
    CHECK(outputs[0].plane != outputs[1].plane);
}

TEST_CASE("panels that are named get the mode wished for them, others the one for all or what they prefer") {
    CardState state = two_panels();
    state.connectors[0].modes.push_back(mode(1280, 720, 60));
    const auto heights = [&](const char* words) {
        const std::vector<Output> outputs = choose_outputs(state, modes(words), true);
        REQUIRE(outputs.size() == 2);
        return std::pair(int{outputs[0].mode.vdisplay}, int{outputs[1].mode.vdisplay});
    };

    CHECK(heights("") == std::pair(1024, 1080));
    CHECK(heights("HDMI-A-2=1280x720") == std::pair(1024, 720));
    CHECK(heights("HDMI-A-1=1280x720, HDMI-A-2=3840x2160") == std::pair(720, 2160));
    CHECK(heights("1280x720, HDMI-A-2=preferred") == std::pair(720, 1080));
    CHECK(heights("DP-1=1280x720") == std::pair(1024, 1080));  // is not there
}

TEST_CASE("a panel that is lit keeps its CRTC when another one comes before it") {
    CardState state = two_panels();
    state.connectors[1].crtc_id = 40;

    const std::vector<Output> outputs = choose_outputs(state, {}, true);

    CHECK(crtc_of(outputs, 51) == 40);
    CHECK(crtc_of(outputs, 50) == 41);
}

TEST_CASE("a panel gives its CRTC away where another one can be lit by no other") {
    CardState state = two_panels();
    state.connectors[1].crtc_id = 40;
    state.connectors[0].crtcs = 0b01;

    const std::vector<Output> outputs = choose_outputs(state, {}, true);

    CHECK(crtc_of(outputs, 50) == 40);
    CHECK(crtc_of(outputs, 51) == 41);
}

TEST_CASE("of more panels than CRTCs as many are lit as can be") {
    CardState state = two_panels();
    state.crtcs = {40};
    state.connectors[1].crtc_id = 40;

    const std::vector<Output> outputs = choose_outputs(state, {}, true);

    REQUIRE(outputs.size() == 1);
    CHECK(outputs[0].connector == 51);
}

TEST_CASE("planes that can lie on any CRTC are given out once each") {
    CardState state = two_panels();
    state.planes = {{.id = 30, .crtcs = 0b11, .is_primary = true},
                    {.id = 31, .crtcs = 0b11, .is_primary = true}};

    const std::vector<Output> outputs = choose_outputs(state, {}, true);

    REQUIRE(outputs.size() == 2);
    CHECK(outputs[0].plane != outputs[1].plane);
}

TEST_CASE("a mode that the card has refused gives way to the preferred, then to smaller ones, then to none") {
    const auto width = [](std::size_t refused) {
        const auto outputs = choose_outputs(card(), modes("1280x720"), true, {{51, refused}});
        return outputs.empty() ? 0 : static_cast<int>(outputs[0].mode.hdisplay);
    };

    CHECK(width(0) == 1280);
    CHECK(width(1) == 1920);
    CHECK(width(2) == 1920);  // at 50 Hz
    CHECK(width(3) == 0);     // 3840 is larger than what the panel prefers
}

TEST_CASE("nothing is in the way of a panel that keeps its CRTC, or that nothing else is lit on") {
    CardState state = card();
    CHECK(obstacles(state, *choose_output(state, {}, true), {}).planes.empty());
    state.connectors[1].crtc_id = 41;
    state.planes[2].crtc_id = 41;

    const Output output = *choose_output(state, {}, true);
    const Obstacles found = obstacles(state, output, std::vector{output});

    CHECK(found.connectors.empty());
    CHECK(found.crtcs.empty());
    CHECK(found.planes.empty());
}

TEST_CASE("a connector that moves to another CRTC has the one it leaves turned off, with its planes") {
    CardState state = card();
    state.connectors[1].crtc_id = 41;
    state.planes[2].crtc_id = 41;
    Output output = *choose_output(state, {}, true);
    output.crtc = 40;
    output.plane = 30;

    const Obstacles found = obstacles(state, output, std::vector{output});

    CHECK(found.crtcs == std::vector<std::uint32_t>{41});
    CHECK(found.planes == std::vector<std::uint32_t>{32});
}

TEST_CASE("a CRTC that something else needs stays on when a connector leaves it") {
    CardState state = two_panels();
    state.connectors[1].crtc_id = 40;
    state.connectors[0].crtc_id = 40;  // both show the console
    const std::vector<Output> outputs = choose_outputs(state, {}, true);

    const auto mover = std::ranges::find(outputs, 41U, &Output::crtc);
    REQUIRE(mover != outputs.end());

    CHECK(obstacles(state, *mover, outputs).crtcs.empty());
}

TEST_CASE("what others have put on a CRTC goes: its connectors and their planes") {
    CardState state = card();
    state.connectors[0].crtc_id = 40;  // no panel there any more
    state.planes[1].crtc_id = 40;      // a mouse pointer

    const Output output = *choose_output(state, {}, true);
    REQUIRE(output.crtc == 40);
    const Obstacles found = obstacles(state, output, std::vector{output});

    CHECK(found.connectors == std::vector<std::uint32_t>{50});
    CHECK(found.planes == std::vector<std::uint32_t>{31});
}

namespace {

void append_event(std::vector<std::byte>& bytes, std::uint32_t type, std::uint64_t number) {
    drm_event_vblank event{};
    event.base = {.type = type, .length = sizeof event};
    event.user_data = number;
    const auto raw = std::as_bytes(std::span(&event, 1));
    bytes.insert(bytes.end(), raw.begin(), raw.end());
}

}  // namespace

TEST_CASE("of a card's events the flips are told, by their numbers, and half an event is none") {
    std::vector<std::byte> events;
    append_event(events, DRM_EVENT_FLIP_COMPLETE, 7);
    append_event(events, DRM_EVENT_VBLANK, 8);
    append_event(events, DRM_EVENT_FLIP_COMPLETE, 1ULL << 40);
    CHECK(flips_in(events) == std::vector<std::uint64_t>{7, 1ULL << 40});

    events.pop_back();
    CHECK(flips_in(events) == std::vector<std::uint64_t>{7});
    CHECK(flips_in({}).empty());
    CHECK(flips_in(std::vector<std::byte>(32)).empty());  // events without a length
}
