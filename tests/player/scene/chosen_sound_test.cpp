#include "player/scene/chosen_sound.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

AudibleShot shot(SourceId source, double area, std::chrono::nanoseconds local) {
    return {.source = source, .path = "a", .stored = {}, .local = local, .area = area};
}

}  // namespace

TEST_CASE("where nothing may be heard nothing is") {
    CHECK(chosen_sound({}) == nullptr);
}

TEST_CASE("the one that came first is heard, of several that came together the largest") {
    std::vector<AudibleShot> shots{shot(1, 100, 9s), shot(2, 150, 8s), shot(3, 120, 9s)};
    CHECK(chosen_sound(shots)->source == 2);
    shots.push_back(shot(4, 180, 6s));
    CHECK(chosen_sound(shots)->source == 2);
    shots.push_back(shot(5, 110, 12s));
    CHECK(chosen_sound(shots)->source == 5);
}

TEST_CASE("one that is twice as large is heard instead, until it is smaller again") {
    for (const bool is_tapped : {false, true, false})
        CHECK(chosen_sound(std::vector{shot(1, 100, 9s), shot(2, is_tapped ? 200 : 199, 1s)})->source ==
              (is_tapped ? 2 : 1));
}
