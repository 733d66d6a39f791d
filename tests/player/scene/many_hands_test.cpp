#include "tests/player/scene/hand_scripts.hpp"

#include <fmt/format.h>

#include <cstdlib>

using namespace vitrine::player;

TEST_CASE("10,000 scripts of up to ten contacts lose no gesture, leave none, and cover no region") {
    const char* const wanted = std::getenv("VITRINE_SCRIPTS");  // how many
    const std::uint64_t count = wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 10'000;
    const char* const from = std::getenv("VITRINE_FIRST_SCRIPT");  // the seed of the first
    const std::uint64_t first = from != nullptr ? std::strtoull(from, nullptr, 10) : 1'000;
    play_scripts(first, count);
    fmt::print("{} scripts, from seed {} on\n", count, first);
}
