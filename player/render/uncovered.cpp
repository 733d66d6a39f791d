#include "player/render/uncovered.hpp"

namespace vitrine::player {

std::vector<Box> uncovered(const Box& area, std::span<const Box> boxes) {
    if (area.is_empty()) return {};
    if (boxes.empty()) return {area};
    const Box hole = intersection(area, boxes.front());
    const std::span<const Box> others = boxes.subspan(1);
    if (hole.is_empty()) return uncovered(area, others);
    std::vector<Box> rest;
    for (const Box& part :
         {Box{area.min, {area.max.x, hole.min.y}}, Box{{area.min.x, hole.min.y}, {hole.min.x, hole.max.y}},
          Box{{hole.max.x, hole.min.y}, {area.max.x, hole.max.y}}, Box{{area.min.x, hole.max.y}, area.max}}) {
        const std::vector<Box> of_part = uncovered(part, others);
        rest.insert(rest.end(), of_part.begin(), of_part.end());
    }
    return rest;
}

}  // namespace vitrine::player
