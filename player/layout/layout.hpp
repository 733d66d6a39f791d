#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace vitrine {

struct MediaRecord;
struct Shot;

}  // namespace vitrine

namespace vitrine::player {

/// One item for packing: a shot's I-Region and the pixels around it. All in source px at the shot's start.
struct LayoutItem {
    Polygon region;     // convex, counter-clockwise, inside `core`
    Box core;           // the part in every frame of the shot; a cell shows no more
    double weight = 1;  // wished area relative to the other items', > 0

    bool operator==(const LayoutItem&) const = default;
};

/// The place of an item: canvas = source * scale + offset.
struct Placement {
    double scale = 1;  // canvas px per source px
    Vec2 offset;       // canvas px

    bool operator==(const Placement&) const = default;
};

/// Items that are placed together, such as the items of one folder. The hull of their I-Regions counts as
/// one.
struct LayoutGroup {
    std::vector<std::size_t> items;

    bool operator==(const LayoutGroup&) const = default;
};

struct WallWay;

/// The places of all items on a canvas, in the order of the items. An immutable value.
struct Layout {
    Vec2 canvas;  // px
    std::vector<Placement> placements;
    std::vector<LayoutGroup> groups;  // none: there are no groups
    double energy = 0;                // share of the canvas that no I-Region covers, in [0, 1]
    std::uint64_t generation = 0;
    bool is_final = false;               // no better layout of the same request follows
    std::shared_ptr<const WallWay> way;  // of an edit: how the wall gets there; none: it finds its way itself
};

/// The item of a shot: its I-Region inside the part that every frame shows. A region that is missing or
/// outside becomes a box in the middle. If a film's drift leaves no common part, the whole frame is taken.
LayoutItem layout_item(const MediaRecord& record, const Shot& shot);

/// The canvas polygon of an item's I-Region.
inline Polygon placed_region(const LayoutItem& item, const Placement& placement) {
    return transformed(item.region, placement.scale, placement.offset);
}

/// The canvas box of an item's core.
inline Box placed_core(const LayoutItem& item, const Placement& placement) {
    return {item.core.min * placement.scale + placement.offset,
            item.core.max * placement.scale + placement.offset};
}

/// The placement that has the effect of one placement and then of another.
inline Placement composed(const Placement& inner, const Placement& outer) {
    return {inner.scale * outer.scale, inner.offset * outer.scale + outer.offset};
}

/// The placement that takes one placement to another.
inline Placement change_between(const Placement& from, const Placement& to) {
    const double scale = to.scale / from.scale;
    return {scale, to.offset - from.offset * scale};
}

}  // namespace vitrine::player
