#include "player/layout/pack/reading_order.hpp"

namespace vitrine::player {

std::size_t inversions(std::span<const Vec2> places, ReadingOrder order) {
    std::size_t count = 0;
    for (std::size_t j = 0; j < places.size(); ++j)
        for (std::size_t i = 0; i < j; ++i)
            if (!order.is_before(places[i], places[j])) ++count;
    return count;
}

}  // namespace vitrine::player
