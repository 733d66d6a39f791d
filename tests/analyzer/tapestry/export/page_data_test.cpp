#include "analyzer/tapestry/export/page_data.hpp"

#include "base/system/atomic_file.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <glib.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace vitrine::analyzer {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

/// Two levels, of two and three tiles. Their files need no pictures.
Tapestry written(const TemporaryDirectory& home) {
    Tapestry tapestry{.path = "film",
                      .duration = seconds(12),
                      .is_complete = true,
                      .folder = "tiles-7",
                      .height = 150,
                      .tile_width = 512,
                      .brick_width = 178,
                      .levels = {}};
    tapestry.levels.push_back({.width = 700, .keyframes = {seconds(1), seconds(4), seconds(9)}});
    tapestry.levels.push_back(
        {.width = 1500, .keyframes = {seconds(1), seconds(2), seconds(3), seconds(4)}, .has_zoom = true});
    for (std::size_t level = 0; level < 2; ++level) {
        for (int tile = 0; tile < tapestry.tiles(level); ++tile) {
            const std::string mark = std::to_string(level) + std::to_string(tile);
            home.write("woven/" + tapestry.tile_name(level, tile), std::string("\xff\xd8\0jpeg", 7) + mark);
            home.write("woven/" + tapestry.zoom_name(level, tile, level == 0), "field" + mark);
        }
    }
    write_tapestry(home.path / "woven", tapestry);
    return tapestry;
}

/// The strings in a script of a tile, out of base64.
std::vector<std::string> strings_in(const std::string& script) {
    std::vector<std::string> strings;
    for (std::size_t at = script.find('"'); at != std::string::npos;) {
        const std::size_t end = script.find('"', at + 1);
        const std::string text = script.substr(at + 1, end - at - 1);
        gsize bytes = 0;
        guchar* decoded = g_base64_decode(text.c_str(), &bytes);
        strings.emplace_back(decoded, decoded + bytes);
        g_free(decoded);
        at = script.find('"', end + 1);
    }
    return strings;
}

nlohmann::json index_in(const std::string& script) {
    const std::string begin = "vitrine.setTapestry(";
    REQUIRE(script.starts_with(begin));
    REQUIRE(script.ends_with(");\n"));
    return nlohmann::json::parse(script.substr(begin.size(), script.size() - begin.size() - 3));
}

}  // namespace

TEST_CASE("a page has the index, and each tile with its zoom fields, and nothing else") {
    const TemporaryDirectory home;
    const Tapestry tapestry = written(home);
    const fs::path out = home.path / "out";
    fs::create_directories(out);
    write_page_data(home.path / "woven", {.name = "a film.mp4", .width = 640, .height = 360}, out);

    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(out))
        if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), out).string());
    std::ranges::sort(names);
    CHECK(names == std::vector<std::string>{"0/000000.js", "0/000001.js", "1/000000.js", "1/000001.js",
                                            "1/000002.js", "tapestry.js"});

    const nlohmann::json index = index_in(read_file(out / "tapestry.js"));
    CHECK(index["version"] == 1);
    CHECK(index["name"] == "a film.mp4");
    CHECK(index["film"] == nlohmann::json{{"file", "film.mp4"}, {"width", 640}, {"height", 360}});
    CHECK(index["duration_ns"] == 12'000'000'000);
    CHECK(index["height"] == 150);
    CHECK(index["tile_width"] == 512);
    CHECK(index["brick_width"] == 178);
    REQUIRE(index["levels"].size() == 2);
    CHECK(index["levels"][0]["width"] == 700);
    CHECK(index["levels"][0]["zoom"] == false);
    CHECK(index["levels"][1]["zoom"] == true);
    CHECK(index["levels"][0]["keyframes_ns"] == nlohmann::json{1'000'000'000, 4'000'000'000, 9'000'000'000});

    for (std::size_t level = 0; level < 2; ++level) {
        for (int tile = 0; tile < tapestry.tiles(level); ++tile) {
            const std::string script = read_file(out / std::to_string(level) / fmt::format("{:06}.js", tile));
            CHECK(script.starts_with(fmt::format("vitrine.addTile({}, {}, \"", level, tile)));
            const std::vector<std::string> strings = strings_in(script);
            REQUIRE(strings.size() == 3);
            CHECK(strings[0] == read_file(home.path / "woven" / tapestry.tile_name(level, tile)));
            const std::string field =
                read_file(home.path / "woven" / tapestry.zoom_name(level, tile, level == 0));
            CHECK(strings[level == 0 ? 1 : 2] == field);
            CHECK(strings[level == 0 ? 2 : 1].empty());
        }
    }
}

TEST_CASE("a film's name cannot become a part of the page, whatever its bytes are") {
    const TemporaryDirectory home;
    (void)written(home);
    const std::string name = "\"<script>&'\\ \xe2\x80\xa8 \xff\xfe \xc3\xa9.mp4";
    write_page_data(home.path / "woven", {.name = name, .width = 2, .height = 2}, home.path);
    const std::string script = read_file(home.path / "tapestry.js");
    CHECK(std::ranges::all_of(script,
                              [](char letter) { return letter == '\n' || (letter >= ' ' && letter < 127); }));
    CHECK(std::ranges::count(script, '\n') == 1);
    CHECK(index_in(script)["name"] == "\"<script>&'\\ \xe2\x80\xa8 \xef\xbf\xbd\xef\xbf\xbd \xc3\xa9.mp4");
}

TEST_CASE("a tile that is missing is named") {
    const TemporaryDirectory home;
    const Tapestry tapestry = written(home);
    fs::remove(home.path / "woven" / tapestry.tile_name(1, 2));
    CHECK_THROWS_WITH(write_page_data(home.path / "woven", {.name = "f"}, home.path),
                      doctest::Contains("000002.jpg"));
    CHECK_FALSE(fs::exists(home.path / "tapestry.js"));
}

}  // namespace vitrine::analyzer
