#include "tests/player/render/canvas_parts.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace vitrine::player;

TEST_CASE("two halves of a canvas are together the whole in 600 frames of changes and drags") {
    const PartsDifference found = compare_parts(600, 1001);
    fmt::print(
        "{} frames; farthest: {} grey levels of a channel; {} pixels with a channel more than one off\n",
        found.frames, found.channel, found.odd);
    CHECK(found.channel <= 2);
    CHECK(found.odd <= 10);  // none is a grey level off
}
