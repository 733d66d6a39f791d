#include "player/scene/chosen_sound.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace vitrine;
using namespace vitrine::player;

namespace {

AudibleShot shot(SourceId source, double area) {
    return {.source = source, .path = "a", .stored = {}, .area = area};
}

}  // namespace

TEST_CASE("where nothing may be heard nothing is") {
    CHECK(chosen_sound({}, 3) == nullptr);
}

TEST_CASE("the largest is heard first, and stays while it is there") {
    const std::vector<AudibleShot> shots{shot(1, 100), shot(2, 150), shot(3, 120)};
    CHECK(chosen_sound(shots, {})->source == 2);
    CHECK(chosen_sound(shots, 3)->source == 3);
    CHECK(chosen_sound(shots, 9)->source == 2);
}

TEST_CASE("one that has become twice as large is heard instead") {
    CHECK(chosen_sound(std::vector{shot(1, 100), shot(2, 199)}, 1)->source == 1);
    CHECK(chosen_sound(std::vector{shot(1, 100), shot(2, 200)}, 1)->source == 2);
}
