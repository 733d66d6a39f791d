#include "player/settings_change.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using Keys = std::vector<std::string>;

TEST_CASE("the same settings change nothing") {
    const SettingsChange change = settings_change({}, {});
    CHECK(change.now.empty());
    CHECK(change.later.empty());
    CHECK_FALSE(change.are_walls_new);
}

TEST_CASE("how the wall looks changes at once, with walls made anew") {
    Settings after;
    after.layout.slots = 3;
    after.show.dwell = std::chrono::seconds(7);
    const SettingsChange change = settings_change({}, after);
    CHECK(change.now == Keys{"layout.slots", "show.dwell_seconds"});
    CHECK(change.are_walls_new);
    CHECK(change.settings.layout.slots == 3);
    CHECK(change.settings.show.dwell == std::chrono::seconds(7));
}

TEST_CASE(
    "what is written over the walls, and how long a touch counts, changes at once, with walls made anew") {
    Settings after;
    after.show.captions = CaptionChoice::names;
    after.show.qr = "https://example.org";
    after.show.share_address = "host";
    after.input.idle = std::chrono::seconds(7);
    after.input.hint = std::chrono::seconds(7);
    const SettingsChange change = settings_change({}, after);
    CHECK(change.now ==
          Keys{"show.captions", "show.qr", "show.share_address", "input.idle_seconds", "input.hint_seconds"});
    CHECK(change.later.empty());
    CHECK(change.are_walls_new);
}

TEST_CASE("the hours of the displays change at once, with the walls as they are") {
    Settings after;
    after.output.on = "08-18";
    after.output.awake = std::chrono::minutes(3);
    after.output.dim = "20-24 50%";
    const SettingsChange change = settings_change({}, after);
    CHECK(change.now == Keys{"output.on", "output.awake_minutes", "output.dim"});
    CHECK_FALSE(change.are_walls_new);
}

TEST_CASE("how it lies on the display changes at once, with the walls as they are") {
    Settings after;
    after.output.rotation = 90;
    const SettingsChange change = settings_change({}, after);
    CHECK(change.now == Keys{"output.rotation"});
    CHECK_FALSE(change.are_walls_new);
    CHECK(change.settings.output.rotation == 90);
}

TEST_CASE("what needs a restart is named and stays as it is until then") {
    Settings after;
    after.media.root = "/elsewhere";
    after.output.api = KmsApi::legacy;
    const SettingsChange change = settings_change({}, after);
    CHECK(change.later == Keys{"media.root", "output.api"});
    CHECK(change.settings.media.root == Settings{}.media.root);
    CHECK(change.settings.output.api == KmsApi::best);
}

TEST_CASE("what only the analyzer reads is not the player's") {
    Settings after;
    after.analyzer.children = 3;
    const SettingsChange change = settings_change({}, after);
    CHECK(change.now.empty());
    CHECK(change.later.empty());
}
