#include "player/stage/folder_words.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("a word fits into the box for its text, and stays in its middle") {
    const Box box{{100, 50}, {300, 90}};
    const Box wide = word_place(box, {.width = 800, .height = 80, .rgba = {}});
    CHECK(wide == Box{{100, 60}, {300, 80}});
    const Box high = word_place(box, {.width = 50, .height = 100, .rgba = {}});
    CHECK(high == Box{{190, 50}, {210, 90}});
}

TEST_CASE("a name without a picture is not drawn") {
    FolderWords words("/nonexistent");
    Frame frame{.names = {{.text = "trips", .box = {{0, 0}, {100, 20}}}}};
    words.draw(frame);
    CHECK(frame.words.empty());
}
