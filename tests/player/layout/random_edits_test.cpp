#include "tests/player/layout/random_edits.hpp"

#include "player/layout/plan/plan_output.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <fstream>

using namespace vitrine;
using namespace vitrine::player;

namespace {

void write_picture(const RandomEdits& edits, std::uint64_t seed) {
    std::vector<NamedItem> named;
    for (const LayoutItem& item : items_of(edits.request()))
        named.push_back({"item", named.size(), item});
    std::ofstream(fmt::format("random_edits_{}.svg", seed))
        << plan_svg({.items = std::move(named), .layout = edits.layout()});
}

}  // namespace

// The bench makes a million (`packing --only edits`).
TEST_CASE("nothing overlaps or leaves the canvas after any of many random edits") {
    for (std::uint64_t seed = 1001; seed <= 1008; ++seed) {
        RandomEdits edits(seed);
        for (int k = 0; k < 100; ++k) {
            const auto fault = edits.step();
            if (fault) write_picture(edits, seed);
            REQUIRE_MESSAGE(!fault, *fault);
        }
    }
}
