#include "player/control/media_name.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;

namespace {

constexpr const char* root = "/srv/vitrine/media";

bool has(const std::string& given, const std::string& folder, const std::string& wanted) {
    const auto names = media_names(given, folder, root);
    return std::ranges::find(names, wanted) != names.end();
}

}  // namespace

TEST_CASE("a file is known by its path on this machine, from where one stands and from the media folder on") {
    CHECK(media_names("/srv/vitrine/media/Advent/a.jpg", "/home", root).front() == "Advent/a.jpg");
    CHECK(media_names("/srv/vitrine/media//Advent/../a.jpg", "/home", root).front() == "a.jpg");
    CHECK(media_names("a.jpg", "/srv/vitrine/media/Advent", root).front() == "Advent/a.jpg");
    CHECK(media_names("../a.jpg", "/srv/vitrine/media/Advent", root).front() == "a.jpg");
    CHECK(has("Advent/a.jpg", "/home/me", "Advent/a.jpg"));
}

TEST_CASE("a file is known as the share shows it on other machines") {
    CHECK(has(R"(\\box\media\Advent\a.jpg)", "/", "Advent/a.jpg"));
    CHECK(has(R"(Z:\Advent\a.jpg)", "/", "Advent/a.jpg"));
    CHECK(has("smb://box/media/Advent/a.jpg", "/", "Advent/a.jpg"));
    CHECK(has("//box/media/a.jpg", "/", "a.jpg"));
    CHECK(has("/Volumes/media/a.jpg", "/", "a.jpg"));
    CHECK(has(R"(Advent\a.jpg)", "/home/me", "Advent/a.jpg"));
}

TEST_CASE("a path of another place of this machine is none of the media folder") {
    CHECK(media_names("/etc/passwd", "/home/me", root).empty());
    CHECK(media_names("", "/srv/vitrine/media", root).empty());
}

TEST_CASE("no name leads out of the media folder") {
    for (const char* given : {"../../etc/passwd", "/srv/vitrine/media/../../etc/passwd",
                              R"(\\box\..\..\etc\passwd)", "smb://box/media/../../../etc/passwd", "..", "."})
        for (const std::string& name : media_names(given, "/srv/vitrine/media", root)) {
            CAPTURE(given);
            CHECK_FALSE(name.starts_with("/"));
            CHECK_FALSE(name.starts_with(".."));
        }
}

TEST_CASE("a name of many folders costs no more than one of a few") {
    std::string given = "//box";
    for (int i = 0; i < 2000; ++i)
        given += "/a";
    CHECK(media_names(given, "/", root).size() <= 70);
    std::string dots = "//box";
    for (int i = 0; i < 1000; ++i)
        dots += "/..";
    CHECK(media_names(dots, "/", root).empty());
}
