#include "tests/player/render/compared_frames.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("thousands of random frames are drawn as the reference draws them") {
    const char* const wanted = std::getenv("VITRINE_FRAMES");  // how many
    const std::uint64_t count = wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 10'000;
    const char* const from = std::getenv("VITRINE_FIRST_FRAME");  // the seed of the first
    const std::uint64_t first = from != nullptr ? std::strtoull(from, nullptr, 10) : 1001;
    ComparedFrames frames;
    Deviation worst;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        CAPTURE(seed);
        const Deviation found = frames.compare(seed, seed % 16 == 0 ? 2160 : 700);
        CAPTURE(found.place);
        CAPTURE(found.grey);
        CAPTURE(found.colour);
        CAPTURE(found.at_edges);
        CAPTURE(found.blocks);
        CHECK(found.is_good());
        worst.grey = std::max(worst.grey, found.grey);
        worst.colour = std::max(worst.colour, found.colour);
        worst.at_edges = std::max(worst.at_edges, found.at_edges);
        worst.blocks = std::max(worst.blocks, found.blocks);
    }
    fmt::print("{} frames; farthest: {:.2f} grey, {:.2f} a channel, {:.2f} at edges, {:.2f} a block's mean\n",
               count, worst.grey, worst.colour, worst.at_edges, worst.blocks);
}
