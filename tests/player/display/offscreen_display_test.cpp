#include "player/display/offscreen_display.hpp"

#include "tests/temporary_directory.hpp"

#include <GLES3/gl3.h>
#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

void fill(Screen& screen, float red, float blue) {
    screen.begin_frame();
    glClearColor(red, 0, blue, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    screen.present(0ns);
}

}  // namespace

TEST_CASE("of several files the first keeps its name and the others are numbered") {
    CHECK(numbered("/tmp/wall.mp4", 0) == "/tmp/wall.mp4");
    CHECK(numbered("/tmp/wall.mp4", 1) == "/tmp/wall-2.mp4");
    CHECK(numbered("wall.of.may.png", 2) == "wall.of.may-3.png");
}

TEST_CASE("screens side by side keep each its own picture and size") {
    OffscreenDisplay display({.screens = {{64, 32}, {48, 16}}}, {}, 30);
    REQUIRE(display.screens().size() == 2);
    auto& first = dynamic_cast<OffscreenScreen&>(*display.screens()[0]);
    auto& second = dynamic_cast<OffscreenScreen&>(*display.screens()[1]);

    fill(first, 1, 0);
    fill(second, 0, 1);

    CHECK(first.name() == "offscreen-1");
    CHECK(second.name() == "offscreen-2");
    const Picture red = first.picture();
    const Picture blue = second.picture();
    REQUIRE(red.pixels.size() == 64 * 32 * 4);
    REQUIRE(blue.pixels.size() == 48 * 16 * 4);
    CHECK(red.pixels[0] == std::byte{255});
    CHECK(red.pixels[2] == std::byte{0});
    CHECK(blue.pixels[0] == std::byte{0});
    CHECK(blue.pixels[2] == std::byte{255});
}

TEST_CASE("every screen is filmed and saved") {
    const TemporaryDirectory directory;
    OffscreenDisplay display({.screens = {{64, 32}, {48, 16}}},
                             {.film = directory.path / "wall.mp4", .snapshot = directory.path / "wall.png"},
                             30);

    for (Screen* screen : display.screens())
        fill(*screen, 1, 0);
    const std::vector<std::string> lines = display.finish_recording();

    CHECK(lines.size() == 2);

    for (const char* name : {"wall.mp4", "wall-2.mp4", "wall.png", "wall-2.png"}) {
        CAPTURE(name);
        CHECK(std::filesystem::file_size(directory.path / name) > 60);
    }
}
