#include "tests/player/scene/hand_scripts.hpp"

using namespace vitrine::player;

TEST_CASE(
    "whatever ten contacts do, none is lost or stuck, and no shot of the wall covers another's region") {
    play_scripts(1, 12);
}
