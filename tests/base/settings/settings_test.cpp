#include "base/media/colour.hpp"
#include "base/settings/setting_keys.hpp"
#include "base/settings/setting_options.hpp"
#include "base/settings/settings_file.hpp"
#include "base/settings/settings_text.hpp"
#include "base/settings/share_address.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/machine.hpp"

#include <CLI/CLI.hpp>
#include <doctest/doctest.h>

#include <sstream>
#include <string>

using namespace vitrine;

namespace {

std::string error_of(const std::string& toml) {
    Settings settings;
    try {
        read_settings(toml, "wall.toml", settings);
    } catch (const SettingsError& error) {
        return error.what();
    }
    return "";
}

std::string uncommented(const std::string& toml) {
    std::string result;
    std::istringstream lines(toml);
    for (std::string line; std::getline(lines, line);)
        result += (line.size() > 1 && line[0] == '#' && line[1] != ' ' ? line.substr(1) : line) + "\n";
    return result;
}

}  // namespace

TEST_CASE("the shipped file is the one that the table of keys gives; the target settings_file writes it") {
    CHECK(read_file(VITRINE_CONFIG) == documented_toml());
}

TEST_CASE("each line of the shipped file has at most 120 characters") {
    std::istringstream lines(documented_toml());
    for (std::string line; std::getline(lines, line);)
        CHECK_MESSAGE(line.size() <= 120, line);
}

TEST_CASE("the shipped file is accepted, as it is and with every key in force") {
    const std::string toml = read_file(VITRINE_CONFIG);
    CHECK(error_of(toml) == "");
    CHECK(error_of(uncommented(toml)) == "");
}

TEST_CASE("a value in the file reaches the settings") {
    Settings settings;
    read_settings("[layout]\nslots = 5\n[show]\ndwell_seconds = 7\n[analyzer]\nregion_mass = 0.6\n",
                  "wall.toml", settings);
    CHECK(settings.layout.slots == 5);
    CHECK(settings.show.dwell == std::chrono::seconds(7));
    CHECK(settings.analyzer.region_mass == doctest::Approx(0.6));
}

TEST_CASE("a wrong value names file, line and what is allowed") {
    CHECK(error_of("\n[layout]\nslots = 900\n") ==
          "wall.toml:3: the value of 'layout.slots' is not allowed; it must be a whole number from 1 to 64");
    CHECK(error_of("[layout]\nslots = \"many\"\n").find("a whole number from 1 to 64") != std::string::npos);
    CHECK(error_of("[output]\nscreen = \"offscreen:big\"\n").find("wall.toml:2") == 0);
    CHECK(error_of("[output]\nrotation = 45\n").find("0, 90, 180 or 270") != std::string::npos);
    CHECK(error_of("[show]\nbackground = \"black\"\n").find("#101014") != std::string::npos);
    CHECK(error_of("[show]\nholidays = \"2026-12-25, 2026-02-30\"\n").find("2026-12-25") !=
          std::string::npos);
    CHECK(error_of("[show]\nholidays = \"2026-12-25, 2026-12-26\"\n").empty());
}

TEST_CASE("a section without a name is an error of the file, not of the program") {
    Settings settings;
    CHECK_THROWS_AS(read_settings("[=show]\n", "a.toml", settings), SettingsError);
}

TEST_CASE("a wrong key or section names file, line and the known ones") {
    CHECK(error_of("[layout]\n\nslotz = 3\n")
              .find("wall.toml:3: there is no key 'layout.slotz'; this section has layout.slots") == 0);
    CHECK(error_of("[lay]\nslots = 3\n").find("wall.toml:1: there is no section [lay]") == 0);
    CHECK(error_of("slots = 3\n").find("wall.toml:1: there is no section [slots]") == 0);
    CHECK(error_of("[layout\n").find("wall.toml:1") == 0);
}

TEST_CASE("a key that an earlier version had is passed over, and told of") {
    Settings settings;
    const auto lines =
        read_settings("[show]\ncrossfade_milliseconds = 400\ndwell_seconds = 7\n", "wall.toml", settings);
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].starts_with(
        "wall.toml:2: 'show.crossfade_milliseconds' is not a setting any more; remove it. "));
    CHECK(settings.show.dwell == std::chrono::seconds(7));
    CHECK_FALSE((documented_toml().find("crossfade_milliseconds") != std::string::npos));
    CHECK_THROWS_AS(apply_setting("show.crossfade_milliseconds", "400", settings), SettingsError);
}

TEST_CASE("an option wins, and a wrong one says what is allowed") {
    Settings settings;
    apply_setting("layout.slots", "3", settings);
    apply_setting("media.root", "2026", settings);
    apply_setting("output.screen", "offscreen:1280x720", settings);
    CHECK(settings.layout.slots == 3);
    CHECK(settings.media.root == "2026");
    CHECK_THROWS_WITH_AS(apply_setting("layout.slots", "0", settings),
                         "--layout.slots '0' is not allowed; it must be a whole number from 1 to 64",
                         SettingsError);
    CHECK_THROWS_AS(apply_setting("layout.nothing", "0", settings), SettingsError);
}

TEST_CASE("a colour is six digits after a hash and nothing else") {
    CHECK(colour_named("#0180fF") == Colour{.red = 1, .green = 128, .blue = 255});
    for (const char* text :
         {"", "#", "#01020", "#0102030", "010203f", "#01020g", "#-10203", "#0x1020", "# 10203"}) {
        CAPTURE(text);
        CHECK_FALSE(colour_named(text));
    }
}

TEST_CASE("the part of a box in a wall is read, and a name with odd characters is one clear sentence") {
    Settings settings;
    read_settings("[wall]\nrole = \"follow\"\nname = \"lobby\"\nbox = \"left\"\nleader = \"10.0.0.1\"\n",
                  "wall.toml", settings);
    CHECK(settings.wall.role == WallRole::follow);
    CHECK(settings.wall.name == "lobby");
    CHECK(settings.wall.leader == "10.0.0.1");
    CHECK(error_of("[wall]\nname = \"a/b\"\n").find("'a/b' is no name") != std::string::npos);
    CHECK(error_of("[wall]\nrole = \"both\"\n") != "");
    CHECK(error_of("[wall]\nleader = \"a b\"\n") != "");
    CHECK(error_of("[wall]\nsocket = \"link.sock\"\n") != "");
}

TEST_CASE("the address of the share has the machine's name, wherever it is asked for") {
    Settings settings;
    CHECK(share_address(settings).empty());
    settings.show.share_address = R"(\\{host}\media, {host})";
    CHECK(share_address(settings) == R"(\\)" + host_name() + R"(\media, )" + host_name());
    settings.show.share_address = "{hos} {";
    CHECK(share_address(settings) == "{hos} {");
}
