#include "base/wall/wall_name.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace vitrine;

TEST_CASE("a name of a wall is one level of a topic and one word of a canvas") {
    for (const char* name : {"lobby", "Lobby-2", "a", "10.0.0.7", "box_1.example"})
        CHECK_MESSAGE(is_wall_name(name), name);
    for (const char* name : {"", "-a", ".a", "a/b", "a b", "a+", "#", "ä", "a\n", "a;b", "$(id)"})
        CHECK_MESSAGE(!is_wall_name(name), name);
    CHECK(is_wall_name(std::string(63, 'a')));
    CHECK_FALSE(is_wall_name(std::string(64, 'a')));
}

TEST_CASE("the fault of a name says what is wrong with it") {
    CHECK(wall_name_fault("lobby") == "");
    CHECK(wall_name_fault("") == "the name is empty");
    CHECK(wall_name_fault(std::string(70, 'a')) == "the name has 70 characters; it has at most 63");
    CHECK(wall_name_fault("a/b").find("'a/b' is no name") == 0);
}
