#include "base/state/visibility.hpp"

#include "base/system/atomic_file.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace vitrine;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

const std::vector<FileVisibility> three_files{
    {.path = "20-21 Evening/late.png",
     .visibility = Visibility::out_of_hours,
     .detail = "from 20:00 to 21:00"},
    {.path = "caf\xe9.jpg", .visibility = Visibility::on_wall, .detail = ""},
    {.path = "new.mp4", .visibility = Visibility::not_analysed, .detail = ""}};

}  // namespace

TEST_CASE(
    "what the player writes of its files is what the analyzer reads, also of names that are not UTF-8") {
    const VisibleByPath read = visible_from_json(visible_json(three_files));

    REQUIRE(read.size() == three_files.size());
    for (const FileVisibility& file : three_files)
        CHECK(read.at(file.path) == file);
}

TEST_CASE("each reason is a sentence with what is known of the file") {
    CHECK(sentence(three_files[0]) == "It is out of its hours: it is shown from 20:00 to 21:00.");
    CHECK(sentence(three_files[1]) == "It is on the wall.");
    CHECK(sentence({.visibility = Visibility::unsupported, .detail = "it has no picture"}) ==
          "It cannot be shown: it has no picture.");
}

TEST_CASE("a file of another version, or with an unknown state, is not read") {
    CHECK_THROWS_AS(visible_from_json("{\"version\":2,\"files\":[]}"), std::runtime_error);
    CHECK_THROWS_AS(visible_from_json(R"({"version":1,"files":[{"path":"a","state":"lost"}]})"),
                    std::runtime_error);
    CHECK_THROWS_AS(visible_from_json("{\"version\":1"), std::runtime_error);
}

TEST_CASE("the player runs for as long as its file is new, and each change is told once") {
    const TemporaryDirectory state;
    const auto now = fs::file_time_type::clock::now();
    VisibleReader reader(state.path);
    CHECK_FALSE(reader.look(now));
    CHECK_FALSE(reader.is_player_running());

    replace_file(state.path / visible_file, visible_json(three_files));
    fs::last_write_time(state.path / visible_file, now);
    CHECK(reader.look(now + 1s));
    CHECK(reader.is_player_running());
    CHECK(reader.files().at("new.mp4").visibility == Visibility::not_analysed);
    CHECK_FALSE(reader.look(now + 20s));

    fs::last_write_time(state.path / visible_file, now + 20s);  // the heartbeat
    CHECK_FALSE(reader.look(now + 40s));
    CHECK(reader.is_player_running());

    CHECK(reader.look(now + 51s));
    CHECK_FALSE(reader.is_player_running());
    CHECK(reader.files().empty());

    fs::last_write_time(state.path / visible_file, now + 60s);
    CHECK(reader.look(now + 61s));
    CHECK(reader.files().size() == three_files.size());
    CHECK(reader.look(now - 1h));  // the clock was set back: the file is from the future
    CHECK_FALSE(reader.is_player_running());
}
