#include "player/words/word_loader.hpp"

#include "base/media/still_picture.hpp"
#include "base/state/word_picture.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <vips/vips.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

void write_png(const fs::path& file, int width, int height, int bands) {
    init_vips();
    fs::create_directories(file.parent_path());
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width) * height * bands);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = static_cast<std::uint8_t>(i);
    VipsImage* image =
        vips_image_new_from_memory(pixels.data(), pixels.size(), width, height, bands, VIPS_FORMAT_UCHAR);
    REQUIRE(vips_pngsave(image, file.c_str(), nullptr) == 0);
    g_object_unref(image);
}

std::vector<LoadedWord> awaited(WordLoader& loader) {
    for (int tries = 0; tries < 2000; ++tries) {
        if (auto words = loader.take(); !words.empty()) return words;
        std::this_thread::sleep_for(5ms);
    }
    return {};
}

}  // namespace

TEST_CASE("a picture of words comes with its opacity") {
    const TemporaryDirectory home;
    write_png(word_picture(home.path, "Rome"), 3, 2, 4);
    WordLoader loader(home.path);
    loader.want({"Rome"});
    const std::vector<LoadedWord> words = awaited(loader);
    REQUIRE(words.size() == 1);
    CHECK(words[0].text == "Rome");
    CHECK(words[0].picture->width == 3);
    CHECK(words[0].picture->height == 2);
    REQUIRE(words[0].picture->rgba.size() == 24);
    CHECK(words[0].picture->rgba[23] == std::byte{23});
}

TEST_CASE("a picture that is set later is found then, and is read once") {
    const TemporaryDirectory home;
    WordLoader loader(home.path, 10ms);
    loader.want({"Oslo"});
    std::this_thread::sleep_for(30ms);
    CHECK(loader.take().empty());
    write_png(word_picture(home.path, "Oslo"), 3, 2, 4);
    CHECK(awaited(loader).size() == 1);
    loader.want({"Oslo"});
    std::this_thread::sleep_for(50ms);
    CHECK(loader.take().empty());
}

TEST_CASE("a file that is no picture of words is passed over") {
    const TemporaryDirectory home;
    write_png(home.path / "high.png", 3, 600, 4);
    home.write("broken.png", "\x89PNG\r\n\x1a\n");
    home.write("empty.png", "");
    for (const char* name : {"high.png", "broken.png", "empty.png", "none.png", "."}) {
        CAPTURE(name);
        CHECK(load_word(home.path / name) == nullptr);
    }
}

TEST_CASE("a picture without opacity covers what is under it") {
    const TemporaryDirectory home;
    write_png(home.path / "opaque.png", 3, 2, 3);
    const auto picture = load_word(home.path / "opaque.png");
    REQUIRE(picture != nullptr);
    REQUIRE(picture->rgba.size() == 3 * 2 * 4);
    for (std::size_t byte = 3; byte < picture->rgba.size(); byte += 4)
        CHECK(picture->rgba[byte] == std::byte{255});
}
