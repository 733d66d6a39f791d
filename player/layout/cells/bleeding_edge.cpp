#include "player/layout/cells/bleeding_edge.hpp"

#include <algorithm>

namespace vitrine::player {

LayoutItem without_bleeding_edge(LayoutItem item, Vec2 picture, const Placement& at) {
    constexpr double bleeding = 3;  // canvas px
    const double depth = bleeding / at.scale;
    const Box region = bounding_box(item.region);
    const auto keep_low = [&](double& side, double limit) {
        if (side > 0) side = std::max(side, std::min(side + depth, limit));
    };
    const auto keep_high = [&](double& side, double limit, double end) {
        if (side < end) side = std::min(side, std::max(side - depth, limit));
    };
    keep_low(item.core.min.x, region.min.x);
    keep_low(item.core.min.y, region.min.y);
    keep_high(item.core.max.x, region.max.x, picture.x);
    keep_high(item.core.max.y, region.max.y, picture.y);
    return item;
}

}  // namespace vitrine::player
