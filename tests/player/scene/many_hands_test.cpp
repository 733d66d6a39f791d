#include "tests/player/scene/hand_scripts.hpp"

using namespace vitrine::player;

TEST_CASE("10,000 scripts of up to ten contacts lose no gesture, leave none, and cover no region") {
    play_scripts(1'000, 10'000);
}
