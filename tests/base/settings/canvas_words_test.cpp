#include "base/settings/canvas_words.hpp"

#include "base/settings/settings.hpp"
#include "base/settings/settings_file.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

namespace {

std::string fault_of(std::string_view text) {
    const CanvasWords words = canvas_named(text);
    CHECK(words.places.empty());
    return words.fault;
}

std::string refused(const std::string& value) {
    Settings settings;
    try {
        apply_setting("output.canvas", value, settings);
    } catch (const SettingsError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a canvas names outputs with their places") {
    const CanvasWords words = canvas_named("HDMI-A-1 0,0; HDMI-A-2 1960,-20.5");
    CHECK(words.fault.empty());
    REQUIRE(words.places.size() == 2);
    CHECK(words.places[0] == OutputPlace{.output = "HDMI-A-1", .at = {0, 0}, .size = {}, .turned = {}});
    CHECK(words.places[1] ==
          OutputPlace{.output = "HDMI-A-2", .at = {1960, -20.5}, .size = {}, .turned = {}});
    CHECK(canvas_named("px: HDMI-A-1 0,0;HDMI-A-2 1960,-20.5;") == words);
    CHECK(canvas_named("").places.empty());
    CHECK(canvas_named("").fault.empty());
}

TEST_CASE("an output of a canvas may have a size and a turn") {
    const CanvasWords words = canvas_named("mm: DP-1  0,0  698x392.5 ; DP-2 720,0 393x698 turned 270");
    REQUIRE(words.places.size() == 2);
    CHECK(words.places[0].size == Vec2{698, 392.5});
    CHECK(!words.places[0].turned);
    CHECK(words.places[1].turned == 270);
}

TEST_CASE("a canvas that is wrong is told in a sentence") {
    CHECK(fault_of("HDMI-A-1") == "'HDMI-A-1' has no place, such as \"HDMI-A-1 1960,0\"");
    CHECK(fault_of("HDMI-A-1 0") == "'0' is no place of 'HDMI-A-1'; a place is like \"1960,0\"");
    CHECK(fault_of("A 0,0 wide") ==
          "the word 'wide' of 'A' is not understood; after its place come its size, like "
          "\"698x393\", and its turn, like \"turned 90\"");
    CHECK(fault_of("A 0,0 turned 45") == "'A' is turned by '45'; it can be turned by 0, 90, 180 or 270");
    CHECK(fault_of("A 0,0 turned").starts_with("the word 'turned' of 'A' is not understood"));
    CHECK(fault_of("inch: A 0,0") == "'inch' is no unit; it is \"mm\" or \"px\"");
    CHECK(fault_of("mm: A 0,0") ==
          "'A' has no size; in mm each output needs the size of its picture, such as \"698x393\"");
    CHECK(fault_of("A 0,0; A 100,0") == "'A' is there twice");
    CHECK(fault_of("A 0,0; B 0,0") == "'A' and 'B' are at one place");
    CHECK(fault_of("A 0,0 100x100; B 99,0 100x100") == "'A' and 'B' overlap");
    CHECK(fault_of("A 0,0 nanx100").starts_with("the word 'nanx100'"));
    CHECK(fault_of("mm:") == "no output is named");
    CHECK(canvas_named("A 0,0 100x100; B 100,0 100x100").fault.empty());
}

TEST_CASE("the error of a setting names the setting and what is wrong with the canvas") {
    const std::string error = refused("A 0,0; B 0,0");
    CHECK(error.find("output.canvas") != std::string::npos);
    CHECK(error.find("'A' and 'B' are at one place; it must be outputs with places like") !=
          std::string::npos);
}
