#include "tests/player/scene/tapestry/touched_places.hpp"

using namespace vitrine::player;

TEST_CASE("500 touches play what is drawn under the finger") {
    TouchedPlaces(1).check(500);
}
