#include "tests/player/scene/tapestry/touched_places.hpp"

using namespace vitrine::player;

TEST_CASE(
    "what plays after a touch begins within half a second of what is drawn under the finger, and there") {
    TouchedPlaces(18).check(60);
}
