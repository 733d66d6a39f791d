#include "player/stage/stages.hpp"

#include "base/settings/settings.hpp"
#include "player/display/offscreen_display.hpp"
#include "player/playback/source_pool.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/chosen_sound.hpp"
#include "player/scene/show.hpp"
#include "player/stage/output_canvas.hpp"
#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <memory>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

Settings lobby_on_the_second() {
    Settings settings;
    settings.output.folders = "offscreen-2=lobby";
    return settings;
}

/// One screen, and what stages show on it.
class OneScreen {
  public:
    std::vector<std::byte> seen(Stages& stages, std::chrono::nanoseconds now) {
        const auto screens = display_.screens();
        stages.set_screens(screens, now);
        stages.show(now, &renderer_, false);
        return dynamic_cast<OffscreenScreen&>(*screens[0]).picture().pixels;
    }

  private:
    OffscreenDisplay display_{{.screens = {{160, 120}}}, {}, 30};
    Renderer renderer_{1, 1};
};

}  // namespace

TEST_CASE("the screen of an output with a folder goes to the stage of that folder, all others to the first") {
    const Settings settings = lobby_on_the_second();
    OffscreenDisplay display({.screens = {{160, 120}, {160, 120}, {160, 120}}}, {}, 30);
    SourcePool sources{{.media = "/nowhere", .store = {}}};
    Stages stages(settings, sources, false);
    REQUIRE(stages.all().size() == 2);
    const auto screens = display.screens();

    stages.set_screens(screens, 0s);
    REQUIRE(stages.first().screens().size() == 2);
    CHECK(stages.first().screens()[1]->name() == "offscreen-3");
    CHECK(stages.first().files().folder().empty());
    REQUIRE(stages.all()[1]->screens().size() == 1);
    CHECK(stages.all()[1]->screens()[0]->name() == "offscreen-2");
    CHECK(stages.all()[1]->files().folder() == "lobby");

    stages.set_screens({}, 1s);
    CHECK(stages.first().screens().empty());
    CHECK(stages.all()[1]->screens().empty());
}

TEST_CASE("the first stage that is seen has a screen, if each output has a folder of its own") {
    Settings settings;
    settings.output.folders = "offscreen-1=hall, offscreen-2=lobby";
    OffscreenDisplay display({.screens = {{160, 120}, {160, 120}}}, {}, 30);
    SourcePool sources{{.media = "/nowhere", .store = {}}};
    Stages stages(settings, sources, false);
    CHECK(&first_seen(stages) == &stages.first());
    const auto screens = display.screens();
    stages.set_screens(screens, 0s);
    CHECK_FALSE(first_seen(stages).screens().empty());
    stages.set_screens(screens.subspan(1), 1s);
    CHECK(first_seen(stages).files().folder() == "lobby");
}

TEST_CASE("the guides of the box that leads are drawn here, too") {
    Settings settings;
    settings.wall = {.role = WallRole::follow, .box = "here"};
    OneScreen screen;
    SourcePool sources{{.media = "/nowhere", .store = {}}};
    const auto others = std::make_shared<OtherOutputs>();
    Stages stages(settings, sources, false, others);
    const auto seen = [&](std::chrono::nanoseconds now) { return screen.seen(stages, now); };
    const auto plain = seen(0s);
    others->has_guides = true;
    CHECK(seen(0s) != plain);
    CHECK_FALSE(stages.has_guides());
    others->has_guides = false;
    CHECK(seen(0s) == plain);
}

TEST_CASE("stages that are made anew have no files yet") {
    const Settings settings = lobby_on_the_second();
    OffscreenDisplay display({.screens = {{160, 120}}}, {}, 30);
    SourcePool sources{{.media = "/nowhere", .store = {}}};
    Stages stages(settings, sources, false);
    stages.set_catalogue(photos(3), {});
    stages.make_anew();

    CHECK(stages.all().size() == 2);
    CHECK(stages.standing().empty());
    CHECK(stages.audible().empty());
}

TEST_CASE("screens keep their picture until new stages have a complete wall, for eight seconds at most") {
    const Settings settings;
    OneScreen screen;
    SourcePool sources{{.media = "/nowhere", .store = {}}};
    Stages stages(settings, sources, false);
    const auto seen = [&](std::chrono::nanoseconds now) { return screen.seen(stages, now); };
    const auto first = seen(0s);
    const auto last = seen(10s);
    CHECK(first != last);  // the idle picture moves
    stages.ask_anew();
    REQUIRE(stages.claim_renewal(10s));
    stages.make_anew();
    CHECK(seen(10s) == last);
    CHECK(seen(17s) == last);
    CHECK(seen(18s) != last);
}

TEST_CASE("however often new stages are asked for, they come at most twice a second") {
    const Settings settings;
    SourcePool sources{{.media = "/nowhere", .store = {}}};
    Stages stages(settings, sources, false);
    CHECK_FALSE(stages.claim_renewal(0s));
    int made = 0;
    for (auto now = 0ms; now < 10s; now += 20ms) {
        stages.ask_anew();
        if (stages.claim_renewal(now)) ++made;
    }
    CHECK(made == 20);
    CHECK_FALSE(stages.claim_renewal(10001ms - 600ms));
    CHECK(stages.claim_renewal(11s));  // what was asked for meanwhile
    CHECK_FALSE(stages.claim_renewal(12s));
}
