#include "player/playback/shot_source.hpp"

#include "tests/player/playback/numbered_film.hpp"

#include <doctest/doctest.h>
#include <vips/vips.h>

#include <filesystem>
#include <fstream>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr auto patience = 20s;
const std::string mp4 = "x264enc bframes=2 b-adapt=false key-int-max=25 speed-preset=veryfast ! mp4mux";

/// Pictures 40 to 63 of a film of 25 a second.
ShotRequest part() {
    return {.source = 1,
            .kind = MediaKind::film,
            .shot = {.begin = 1600ms, .end = 2560ms, .region = {.polygon = {}, .drift = {25, -50}}},
            .width = 160,
            .height = 96};
}

/// A PNG of one colour, 40 x 20 px. @param alpha  of 255
void write_see_through(const std::string& file, Colour colour, unsigned char alpha) {
    REQUIRE(vips_init("test") == 0);
    std::vector<unsigned char> pixels;
    for (int i = 0; i < 40 * 20; ++i)
        pixels.insert(pixels.end(), {colour.red, colour.green, colour.blue, alpha});
    VipsImage* image =
        vips_image_new_from_memory_copy(pixels.data(), pixels.size(), 40, 20, 4, VIPS_FORMAT_UCHAR);
    REQUIRE(image);
    image->Type = VIPS_INTERPRETATION_sRGB;
    REQUIRE(vips_image_write_to_file(image, file.c_str(), nullptr) == 0);
    g_object_unref(image);
}

}  // namespace

TEST_CASE("at each time the shot shows the newest picture due, loop after loop") {
    const Folder folder;
    write_film(folder.path / "film", {.rate = 25, .chain = mp4});
    ShotSource source(folder.path / "film", part());
    for (int i = 0; i < 3 * 24; ++i) {
        for (const auto within : {0ms, 20ms, 38ms}) {
            const auto local = i * 40ms + within;
            REQUIRE(source.wait_for(local, patience));
            REQUIRE(number(source.picture_at(local).value()) == 40 + i % 24);
        }
        const Vec2 slide = source.picture_at(i * 40ms + 38ms)->slide;
        CHECK(length(slide - Vec2{25 * 0.04 * (i % 24), -50 * 0.04 * (i % 24)}) < 1e-6);
    }
    CHECK(source.counts().late == 0);
    CHECK_FALSE(source.failure());
}

TEST_CASE("at a lower rate than the film's pictures are left out, none comes late") {
    const Folder folder;
    write_film(folder.path / "film", {.rate = 25, .chain = mp4});
    ShotSource source(folder.path / "film", part());
    for (int i = 0; i < 40; ++i) {
        const auto local = i * 100ms;
        REQUIRE(source.wait_for(local, patience));
        REQUIRE(number(source.picture_at(local).value()) == 40 + (i * 100 % 960) / 40);
    }
    CHECK(source.counts().late == 0);
}

TEST_CASE("a shot whose decoding cannot keep up is late and then goes on from where it is") {
    const Folder folder;
    write_film(folder.path / "film", {.rate = 25, .chain = mp4});
    ShotSource source(folder.path / "film", part());
    source.wait_until_ready(patience);
    source.picture_at(0s);
    source.picture_at(1h);
    CHECK(source.counts().late == 1);
    REQUIRE(source.wait_for(1h, patience));
    const int shown = number(source.picture_at(1h).value());
    REQUIRE(source.wait_for(1h + 80ms, patience));
    CHECK(number(source.picture_at(1h + 80ms).value()) == shown + 2);
}

TEST_CASE("nothing is there before the first picture, and asking does not wait") {
    const Folder folder;
    write_film(folder.path / "film", {.rate = 25, .chain = mp4});
    ShotSource source(folder.path / "film", part());
    const bool was_ready = source.is_ready();
    CHECK(source.picture_at(0s).has_value() >= was_ready);
    source.wait_until_ready(patience);
    CHECK(source.is_ready());
    CHECK(source.picture_at(0s).has_value());
}

TEST_CASE("a photo is one picture at the size asked for that stays") {
    const Folder folder;
    write_photo(folder.path / "photo.bmp");
    ShotSource source(
        folder.path / "photo.bmp",
        {.source = 1, .shot = {.region = {.polygon = {}, .drift = {9, 9}}}, .width = 20, .height = 10});
    REQUIRE(source.wait_for(0s, patience));
    const Sample sample = source.picture_at(0s).value();
    CHECK(sample.width == 20);
    CHECK(sample.height == 10);
    CHECK(std::to_integer<int>(sample.pixels[5 * sample.stride + 4 * 4 + 2]) > 240);  // red
    CHECK(std::to_integer<int>(sample.pixels[5 * sample.stride + 4 * 4 + 3]) == 255);
    CHECK(std::to_integer<int>(sample.pixels[5 * sample.stride + 4 * 15 + 0]) > 240);  // blue
    std::filesystem::remove(folder.path / "photo.bmp");
    CHECK(source.wait_for(1h, patience));
    CHECK(source.picture_at(1h)->pixels.data() == sample.pixels.data());
    CHECK(sample.slide == Vec2{});
    CHECK(source.counts().late == 0);
    CHECK_FALSE(source.failure());
}

TEST_CASE("the background shows half through a half-transparent photo") {
    const Folder folder;
    write_see_through(folder.path / "photo.png", {.red = 200, .green = 100, .blue = 0}, 128);
    ShotSource source(folder.path / "photo.png", {.source = 1, .width = 20, .height = 10},
                      {.background = {.red = 0, .green = 200, .blue = 100}});
    REQUIRE(source.wait_for(0s, patience));
    const Sample sample = source.picture_at(0s).value();
    const std::size_t middle = 5 * sample.stride + std::size_t{4} * 10;
    for (const auto& [channel, value] : {std::pair{2, 100}, {1, 150}, {0, 50}, {3, 255}})
        CHECK(std::abs(std::to_integer<int>(sample.pixels[middle + static_cast<std::size_t>(channel)]) -
                       value) <= 2);
}

TEST_CASE("a photo asked for in another size is read again and the old one shown meanwhile") {
    const Folder folder;
    write_photo(folder.path / "photo.bmp");
    ShotSource source(folder.path / "photo.bmp", {.source = 1, .width = 20, .height = 10});
    REQUIRE(source.wait_for(0s, patience));
    while (!source.has_ended())
        std::this_thread::yield();
    CHECK_FALSE(source.is_outdated());
    source.resize(30, 15);
    CHECK(source.is_outdated());
    CHECK(source.picture_at(1s)->width == 20);
    source.read_photo();
    source.resize(40, 20);  // while it is read
    while (!source.has_ended()) {
        CHECK(source.picture_at(1s).has_value());
    }
    CHECK(source.picture_at(1s)->width == 30);
    REQUIRE(source.wait_for(1s, patience));
    CHECK(source.picture_at(1s)->width == 40);
    CHECK_FALSE(source.is_outdated());
}

TEST_CASE("a photo that has gone when it is to be read again stays as it is") {
    const Folder folder;
    write_photo(folder.path / "photo.bmp");
    ShotSource source(folder.path / "photo.bmp", {.source = 1, .width = 20, .height = 10});
    REQUIRE(source.wait_for(0s, patience));
    while (!source.has_ended())
        std::this_thread::yield();
    std::filesystem::remove(folder.path / "photo.bmp");
    source.resize(40, 20);
    CHECK_FALSE(source.wait_for(1s, patience));
    while (!source.has_ended())
        std::this_thread::yield();
    CHECK(source.picture_at(2s)->width == 20);
    CHECK_FALSE(source.is_outdated());  // it is not tried for ever
    CHECK_FALSE(source.failure());
}

TEST_CASE("a photo that cannot be read is a failure with a reason") {
    const Folder folder;
    std::ofstream(folder.path / "photo.jpg") << std::string(20000, 'x');
    ShotSource source(folder.path / "photo.jpg", {.source = 1, .width = 20, .height = 10});
    CHECK_FALSE(source.wait_for(0s, patience));
    CHECK(source.failure().value_or("").size() > 10);
    CHECK_FALSE(source.is_ready());
}
