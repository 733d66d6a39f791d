#include "player/display/offscreen_screen.hpp"

#include "tests/temporary_directory.hpp"

#include <GLES3/gl3.h>
#include <doctest/doctest.h>
#include <gst/app/gstappsink.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

// The upper half red, the lower half blue.
void draw_halves(const OffscreenScreen& screen) {
    const int half = screen.height() / 2;
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, half, screen.width(), screen.height() - half);  // GL counts from the bottom
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glScissor(0, 0, screen.width(), half);
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

struct Film {
    int width = 0;
    int height = 0;
    int pictures = 0;
    std::string profile;
    std::chrono::nanoseconds end{0};
};

Film read_film(const std::filesystem::path& path) {
    gst_init(nullptr, nullptr);
    const std::string chain =
        "filesrc location=" + path.string() + " ! qtdemux ! h264parse ! appsink name=end sync=false";
    GstElement* pipeline = gst_parse_launch(chain.c_str(), nullptr);
    GstElement* sink = gst_bin_get_by_name(GST_BIN(pipeline), "end");
    gst_element_set_state(pipeline, GST_STATE_PLAYING);
    Film film;
    // A film that is cut off ends with an error, after which no sample comes.
    while (GstSample* sample = gst_app_sink_try_pull_sample(GST_APP_SINK(sink), 5 * GST_SECOND)) {
        const GstBuffer* buffer = gst_sample_get_buffer(sample);
        const GstSegment* segment = gst_sample_get_segment(sample);
        const auto begin = gst_segment_to_stream_time(segment, GST_FORMAT_TIME, GST_BUFFER_PTS(buffer));
        film.end = std::max(film.end, std::chrono::nanoseconds(begin + GST_BUFFER_DURATION(buffer)));
        ++film.pictures;
        const GstStructure* format = gst_caps_get_structure(gst_sample_get_caps(sample), 0);
        gst_structure_get_int(format, "width", &film.width);
        gst_structure_get_int(format, "height", &film.height);
        film.profile = gst_structure_get_string(format, "profile");
        gst_sample_unref(sample);
    }
    gst_element_set_state(pipeline, GST_STATE_NULL);
    gst_object_unref(sink);
    gst_object_unref(pipeline);
    return film;
}

}  // namespace

TEST_CASE("what is drawn off screen is read back from the top") {
    OffscreenScreen screen({.width = 64, .height = 32});

    screen.begin_frame();
    draw_halves(screen);
    screen.present(0ns);
    const Picture picture = screen.picture();

    REQUIRE(picture.pixels.size() == 64 * 32 * 4);
    CHECK(picture.pixels[0] == std::byte{255});
    CHECK(picture.pixels[2] == std::byte{0});
    CHECK(picture.pixels[picture.pixels.size() - 4] == std::byte{0});
    CHECK(picture.pixels[picture.pixels.size() - 2] == std::byte{255});
}

TEST_CASE("an off-screen picture is saved as a PNG of its size") {
    const TemporaryDirectory directory;
    OffscreenScreen screen({.width = 64, .height = 32});
    screen.begin_frame();
    draw_halves(screen);

    save_png(screen.picture(), directory.path / "shown.png");

    std::ifstream file(directory.path / "shown.png", std::ios::binary);
    std::array<char, 26> head{};
    REQUIRE(file.read(head.data(), head.size()));
    CHECK(std::string_view(head.data() + 1, 3) == "PNG");
    CHECK(head[19] == 64);
    CHECK(head[23] == 32);
    CHECK(head[24] == 8);  // bits
    CHECK(head[25] == 2);  // RGB without alpha
}

TEST_CASE("a picture that cannot be written names the file") {
    Picture picture{.width = 2, .height = 2, .pixels = std::vector<std::byte>(16)};

    try {
        save_png(picture, "/nowhere/shown.png");
        FAIL("saved into a directory that is not there");
    } catch (const std::runtime_error& error) {
        CHECK(std::string(error.what()).find("/nowhere/shown.png") != std::string::npos);
    }
}

TEST_CASE("a film holds every picture for its time") {
    const TemporaryDirectory directory;
    const std::filesystem::path path = directory.path / "wall.mp4";
    OffscreenScreen screen({.width = 128, .height = 72, .film = path, .film_rate = 25});

    for (int i = 0; i < 50; ++i) {
        screen.begin_frame();
        draw_halves(screen);
        screen.present(3s + i * 40ms);
    }
    screen.finish_film();

    const Film film = read_film(path);
    CHECK(film.width == 128);
    CHECK(film.height == 72);
    CHECK(film.pictures == 50);
    CHECK(film.end == 2s);
    CHECK(film.profile.find("4:4:4") == std::string::npos);  // television sets do not play it
}

TEST_CASE("a film that is cut off plays up to its last fragment") {
    const TemporaryDirectory directory;
    const std::filesystem::path path = directory.path / "wall.mp4";
    const std::filesystem::path cut = directory.path / "cut.mp4";
    OffscreenScreen screen({.width = 128, .height = 72, .film = path, .film_rate = 25});

    for (int i = 0; i < 400; ++i) {  // 16 s
        screen.begin_frame();
        screen.present(i * 40ms);
    }
    std::filesystem::copy_file(path, cut);  // it is as if the player was killed here

    CHECK(read_film(cut).pictures >= 100);
}

TEST_CASE("a film that is not finished by hand ends with its screen") {
    const TemporaryDirectory directory;
    const std::filesystem::path path = directory.path / "wall.mp4";

    {
        OffscreenScreen screen({.width = 128, .height = 72, .film = path, .film_rate = 25});
        screen.begin_frame();
        screen.present(0ns);
    }

    CHECK(read_film(path).pictures == 1);
}

TEST_CASE("a film that cannot be written says so and names the file") {
    const auto film_it = [] {
        OffscreenScreen screen({.width = 128, .height = 72, .film = "/nowhere/wall.mp4"});
        screen.begin_frame();
        for (int i = 0; i < 20; ++i)
            screen.present(i * 33ms);
        screen.finish_film();
    };

    try {
        film_it();
        FAIL("filmed into a directory that is not there");
    } catch (const std::runtime_error& error) {
        CHECK(std::string(error.what()).find("/nowhere/wall.mp4") != std::string::npos);
    }
}
