#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace vitrine {

struct MediaRecord;
struct Shot;

}  // namespace vitrine

namespace vitrine::player {

/// One item to be packed: a shot's I-Region with the pixels around it. All in source px at the shot's begin.
struct LayoutItem {
    Polygon region;     // convex, counter-clockwise, inside `core`
    Box core;           // the part that every frame of the shot shows: a cell may show no more
    double weight = 1;  // wished area relative to the others, > 0

    bool operator==(const LayoutItem&) const = default;
};

/// The place of an item: canvas = source * scale + offset.
struct Placement {
    double scale = 1;  // canvas px per source px
    Vec2 offset;       // canvas px

    bool operator==(const Placement&) const = default;
};

/// Items that stand together, as the items of one folder: the hull of their I-Regions counts as one.
struct LayoutGroup {
    std::vector<std::size_t> items;

    bool operator==(const LayoutGroup&) const = default;
};

/// The places of all items on a canvas, in the order of the items. An immutable value.
struct Layout {
    Vec2 canvas;  // px
    std::vector<Placement> placements;
    std::vector<LayoutGroup> groups;  // none: all stand by themselves
    double energy = 0;                // share of the canvas that no I-Region covers, in [0, 1]
    std::uint64_t generation = 0;
    bool is_final = false;  // no better one follows for the same request
};

/// The item of a shot: its I-Region inside the part that every frame shows. A region that is missing or lies
/// outside becomes a box in the middle. A film whose drift leaves no common part counts its whole frame.
LayoutItem layout_item(const MediaRecord& record, const Shot& shot);

/// The canvas polygon of an item's I-Region.
inline Polygon placed_region(const LayoutItem& item, const Placement& placement) {
    return transformed(item.region, placement.scale, placement.offset);
}

}  // namespace vitrine::player
