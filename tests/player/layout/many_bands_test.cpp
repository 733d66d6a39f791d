#include "tests/player/layout/banded_edits.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>

using namespace vitrine::player;

TEST_CASE("no region rests under a bezel after any of 10,000 plans and edits") {
    constexpr int edits_a_wall = 20;
    const char* const wanted = std::getenv("VITRINE_EDITS");  // how many
    const int count = wanted != nullptr ? std::atoi(wanted) : 10'000;
    double hidden = 0;
    int wrong = 0;
    int done = 0;
    const char* const from = std::getenv("VITRINE_FIRST_EDIT");  // the seed of the first wall
    for (std::uint64_t seed = from != nullptr ? std::strtoull(from, nullptr, 10) : 1001; done < count;
         ++seed) {
        BandedEdits edits(seed);
        for (int k = 0; k < edits_a_wall && done < count; ++k, ++done) {
            const auto fault = edits.step();
            hidden += edits.under_bands();
            if (!fault) continue;
            ++wrong;
            fmt::print("seed {}, edit {}: {}\n", seed, k, *fault);
        }
    }
    fmt::print("{} plans and edits: {} px^2 of regions under bands, {} layouts wrong\n", done, hidden, wrong);
    CHECK(hidden == 0);
    CHECK(wrong == 0);
}
