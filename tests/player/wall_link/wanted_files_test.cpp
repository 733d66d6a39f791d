// A follower tells which files are fetched first.

#include "base/system/atomic_file.hpp"
#include "player/wall_link/wanted_files.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

TEST_CASE("the files are told line by line, when others are wanted") {
    const TemporaryDirectory folder;
    const auto file = folder.path / "wanted";
    WantedFiles wanted(file);
    REQUIRE(wanted.is_due(0s));
    wanted.tell({"b/0.mkv", "a/photo"}, 0s);
    CHECK(read_file(file) == "a/photo\nb/0.mkv\n");
    CHECK_FALSE(wanted.is_due(400ms));
    REQUIRE(wanted.is_due(500ms));
    std::filesystem::remove(file);
    wanted.tell({"b/0.mkv", "a/photo"}, 500ms);
    CHECK_FALSE(std::filesystem::exists(file));
    wanted.tell({}, 1s);
    CHECK(read_file(file).empty());
}

TEST_CASE("what could not be written is written later") {
    const TemporaryDirectory folder;
    WantedFiles wanted(folder.path / "state" / "wanted");
    wanted.tell({"a/photo"}, 0s);
    std::filesystem::create_directory(folder.path / "state");
    wanted.tell({"a/photo"}, 1s);
    CHECK(read_file(folder.path / "state" / "wanted") == "a/photo\n");
}
