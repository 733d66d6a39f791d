#include "player/scene/tapestry/tapestry_moment.hpp"

namespace vitrine::player {

TapestryMoment moved(TapestryMoment seen, std::chrono::nanoseconds by) {
    seen.opened += by;
    for (std::optional<SeenSpan>* const playing : {&seen.above, &seen.in_place})
        if (*playing) (*playing)->began += by;
    return seen;
}

}  // namespace vitrine::player
