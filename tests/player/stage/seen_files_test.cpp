#include "player/stage/seen_files.hpp"

#include "base/settings/settings.hpp"
#include "player/display/picture.hpp"
#include "player/playback/source_pool.hpp"
#include "player/stage/output_canvas.hpp"
#include "player/stage/stages.hpp"
#include "tests/player/scene/scene_media.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

Picture grey_picture() {
    constexpr std::size_t pixels = std::size_t{16} * 9;
    return {.width = 16, .height = 9, .pixels = std::vector<std::byte>(pixels * 4, std::byte{200})};
}

}  // namespace

TEST_CASE("on a box without a screen the files are seen that its wall shows on other boxes") {
    const TemporaryDirectory directory;
    save_png(grey_picture(), directory.path / "grey.png");
    Settings settings;
    settings.wall = {.role = WallRole::lead, .box = "here"};
    settings.output.canvas = "there/DP-1 0,0";
    const auto others = std::make_shared<OtherOutputs>();
    SourcePool sources{{.media = directory.path.string(), .store = {}}};
    Stages stages(settings, sources, true, others);
    stages.set_catalogue(std::vector<MediaRecord>{photo("grey.png")}, {});
    SeenFiles seen;
    std::chrono::nanoseconds now{0};
    const auto look = [&] {
        for (const auto end = now + 5s; now < end; now += 100ms) {
            stages.set_screens({}, now);
            stages.show(now, nullptr, false);
        }
        return seen.look(stages, sources, now);
    };
    using Paths = std::set<std::string>;
    CHECK(look() == Paths{});
    others->outputs = {{"there/DP-1", 320, 180, {}}};
    CHECK(look() == Paths{"grey.png"});
    others->outputs.clear();
    CHECK(look() == Paths{});
}
