#include "tests/player/render/compared_frames.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// Compares one random frame. @param max_side  px
void check(ComparedFrames& frames, std::uint64_t seed, int max_side) {
    CAPTURE(seed);
    const Deviation found = frames.compare(seed, max_side);
    CAPTURE(found.place);
    CAPTURE(found.worst());
    CHECK(found.is_good());
}

}  // namespace

TEST_CASE("random frames are drawn as the reference draws them") {
    ComparedFrames frames;
    for (std::uint64_t seed = 1; seed <= 24; ++seed)
        check(frames, seed, seed % 8 == 0 ? 1080 : 400);
}

// Each of these was out of its bounds once: translucent edges that lie over one another are rounded at each,
// and centres of pixels lie on sides of triangles.
TEST_CASE("frames with many translucent edges over one another are drawn as the reference draws them") {
    ComparedFrames frames;
    for (const std::uint64_t seed : {5891, 7050, 10439, 10855, 10923})
        check(frames, seed, 700);
}

// Without set_mesa_options() the processor leaves out tiles of 64 x 64 px of these while they fade.
TEST_CASE("tiles that a triangle covers whole are blended as the reference blends them") {
    ComparedFrames frames;
    for (const std::uint64_t seed : {27, 37})
        check(frames, seed, 700);
}

// Without set_mesa_options() pixels of these are more than 2 levels of grey off, as textures are read in
// steps.
TEST_CASE("smaller copies and planes are read as finely as the reference reads them") {
    ComparedFrames frames;
    for (const std::uint64_t seed : {3028, 3979})
        check(frames, seed, 700);
}

// The filler of a cell in this frame has a triangle so small that its corners are one.
TEST_CASE("a frame with a flat triangle is drawn as the reference draws it") {
    ComparedFrames frames;
    check(frames, 5067, 700);
}
