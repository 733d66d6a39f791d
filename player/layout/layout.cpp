#include "player/layout/layout.hpp"

#include "base/state/record.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

constexpr double min_side = 8;  // source px of a core that can be shown
constexpr double min_area = 1;  // source px^2 of a region
constexpr double middle_share =
    0.6;  // side of the box that replaces a missing region, as a share of the core's

Polygon middle_box(const Box& core) {
    const Vec2 half = (core.max - core.min) * (middle_share / 2);
    return to_polygon({core.centre() - half, core.centre() + half});
}

}  // namespace

LayoutItem layout_item(const MediaRecord& record, const Shot& shot) {
    LayoutItem item;
    item.core = core(record, shot);
    if (std::min(item.core.width(), item.core.height()) < min_side) item.core = active_picture(record, shot);
    item.core.max = {std::max(item.core.max.x, item.core.min.x + 1),
                     std::max(item.core.max.y, item.core.min.y + 1)};
    item.region = clipped(shot.region.polygon, item.core);
    if (area(item.region) < min_area) item.region = middle_box(item.core);
    return item;
}

}  // namespace vitrine::player
