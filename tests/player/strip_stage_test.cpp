#include "player/strip_stage.hpp"

#include "player/display/offscreen_display.hpp"
#include "player/stage.hpp"
#include "tests/player/scene/drawn_tapestry.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

using Rgb = std::array<int, 3>;

constexpr std::array<Rgb, 4> colours{{{200, 40, 40}, {40, 200, 40}, {40, 40, 200}, {200, 200, 40}}};

Picture plain(int width, int height, const Rgb& colour) {
    Picture picture{.width = width, .height = height, .pixels = {}};
    for (int i = 0; i < width * height; ++i)
        for (const int channel : {colour[0], colour[1], colour[2], 255})
            picture.pixels.push_back(static_cast<std::byte>(channel));
    return picture;
}

/// Each level of one colour.
void write_tiles(const std::filesystem::path& directory, const Tapestry& tapestry) {
    for (std::size_t level = 0; level < tapestry.levels.size(); ++level) {
        for (int tile = 0; tile < tapestry.tiles(level); ++tile) {
            const int width =
                std::min(tapestry.tile_width, tapestry.levels[level].width - tile * tapestry.tile_width);
            const auto file = directory / tapestry.tile_name(level, tile);
            std::filesystem::create_directories(file.parent_path());
            save_png(plain(width, tapestry.height, colours.at(level)), file);
        }
    }
    write_tapestry(directory, tapestry);
}

bool is_near(const Picture& picture, int x, int y, const Rgb& colour) {
    const std::size_t first = (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                               static_cast<std::size_t>(x)) *
                              4;
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(std::to_integer<int>(picture.pixels[first + i]) - colour[i]) > 8) return false;
    return true;
}

MediaRecord grey_photo() {
    MediaRecord record{.path = "grey.png", .state = MediaState::ready, .width = 160, .height = 90};
    record.shots = {Shot{.region = {.polygon = to_polygon(Box{{60, 25}, {100, 65}})}}};
    return record;
}

/// A wall of one photo, of which there is a tapestry.
struct Theatre {
    Theatre() : display({.screens = {{320, 180}}}, {}, 30) {
        save_png(plain(160, 90, {120, 120, 120}), directory.path / "grey.png");
        write_tiles(tapestry(), drawn_tapestry());
        settings.state.directory = directory.path.string();
        settings.layout.max_enlargement = 100;
        settings.input.idle = 20s;
        stage = std::make_unique<Stage>(
            settings, StageOptions{.number = 3, .folder = {}, .await_sources = [this] { await(); }}, sources);
        stage->set_catalogue(std::vector<MediaRecord>{grey_photo()});
        const auto screens = display.screens();
        stage->set_screens({screens.begin(), screens.end()}, 0s);
    }

    std::filesystem::path tapestry() const { return directory.path / "tapestry" / record_id("grey.png"); }

    void await() {
        for (const SourceEvent& event : sources.wait_until_ready(10s)) {
            REQUIRE(stage->owns(event.source));
            stage->tell(event);
        }
    }

    void play(std::chrono::nanoseconds duration) {
        for (const auto end = now + duration; now < end; now += 100ms)
            stage->show(now, renderer);
    }

    void tap(Vec2 at) {
        stage->take(Contact{.kind = Contact::Kind::down, .at = at, .time = now});
        stage->take(Contact{.kind = Contact::Kind::up, .at = at, .time = now + 50ms});
        now += 100ms;
    }

    Picture picture() { return dynamic_cast<OffscreenScreen&>(*display.screens()[0]).picture(); }

    TemporaryDirectory directory;
    Settings settings;
    OffscreenDisplay display;
    Renderer renderer{1, 1};
    SourcePool sources{{.media = directory.path.string(), .store = {}}};
    std::unique_ptr<Stage> stage;
    std::chrono::nanoseconds now = 0s;
};

}  // namespace

TEST_CASE("two taps on a film open its strip; the wheel goes through its levels, a key back to the wall") {
    Theatre theatre;
    theatre.play(2s);
    REQUIRE(is_near(theatre.picture(), 160, 90, {120, 120, 120}));

    theatre.tap({160, 90});
    theatre.tap({160, 90});
    theatre.play(2s);
    CHECK(is_near(theatre.picture(), 160, 140, colours[0]));
    CHECK_FALSE(is_near(theatre.picture(), 160, 60, {120, 120, 120}));

    for (const std::size_t level : {1U, 2U, 3U}) {
        theatre.stage->take(Wheel{.notches = 1, .at = {160, 140}, .time = theatre.now});
        theatre.play(1s);
        CHECK(is_near(theatre.picture(), 160, 140, colours.at(level)));
    }
    theatre.stage->take(Wheel{.notches = -1, .at = {160, 140}, .time = theatre.now});
    theatre.play(400ms);
    CHECK_FALSE(is_near(theatre.picture(), 160, 140, colours[3]));  // between both
    CHECK_FALSE(is_near(theatre.picture(), 160, 140, colours[2]));
    theatre.play(1s);
    CHECK(is_near(theatre.picture(), 160, 140, colours[2]));

    theatre.stage->take(KeyPress{.key = Key::back, .time = theatre.now});
    theatre.play(2s);
    CHECK(is_near(theatre.picture(), 160, 90, {120, 120, 120}));
}

TEST_CASE("a strip that nobody touches gives way to the wall") {
    Theatre theatre;
    theatre.play(2s);
    theatre.tap({160, 90});
    theatre.tap({160, 90});
    theatre.play(15s);
    CHECK_FALSE(is_near(theatre.picture(), 160, 60, {120, 120, 120}));
    theatre.play(10s);
    CHECK(is_near(theatre.picture(), 160, 60, {120, 120, 120}));
}

TEST_CASE(
    "a tile that cannot be read is stood in for by the coarsest level; another renderer gets all anew") {
    Theatre theatre;
    std::filesystem::remove(theatre.tapestry() / drawn_tapestry().tile_name(1, 1));
    theatre.play(1s);
    theatre.tap({160, 90});
    theatre.tap({160, 90});
    theatre.stage->take(KeyPress{.key = Key::nearer, .time = theatre.now});
    theatre.play(2s);
    const auto columns = [&](const Rgb& colour) {
        const Picture picture = theatre.picture();
        int count = 0;
        for (int x = 0; x < 320; ++x)
            count += is_near(picture, x, 140, colour) ? 1 : 0;
        return count;
    };
    const int coarse = columns(colours[0]);
    const int fine = columns(colours[1]);
    CHECK(coarse > 50);
    CHECK(fine > 50);

    theatre.stage->forget_uploads();
    Renderer another(1, 1);
    theatre.stage->show(theatre.now, another);
    CHECK(columns(colours[0]) == coarse);
    CHECK(columns(colours[1]) == fine);
}

TEST_CASE("no frame waits for tiles, and none is given more than a few") {
    Theatre theatre;
    StripStage strip(theatre.tapestry(), std::nullopt, {320, 180}, {.first_source = 1});
    std::size_t most = 0;
    std::chrono::nanoseconds now = 0s;
    for (std::size_t before = 0; strip.strip().tiles() < 4; now += 16ms) {  // those of the test's timeout
        strip.step(now, theatre.renderer);
        most = std::max(most, strip.strip().tiles() - before);
        before = strip.strip().tiles();
    }
    CHECK(most <= StripStage::most_uploads);
}

TEST_CASE("a directory without a tapestry is named") {
    const TemporaryDirectory directory;
    CHECK_THROWS_WITH(StripStage(directory.path, std::nullopt, {320, 180}, {}),
                      doctest::Contains("index.json"));
}
