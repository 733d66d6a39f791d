#pragma once

#include "player/layout/cells/cells.hpp"
#include "player/layout/plan/plan.hpp"

#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

/// An item of a plan and where it comes from.
struct NamedItem {
    std::string path;  // relative to the media root, any bytes
    std::size_t shot = 0;
    LayoutItem item;
};

/// A layout with all that can be said of it.
struct PlanResult {
    std::vector<NamedItem> items;
    Layout layout;
    std::vector<Cell> cells;
    double region_visible = 1;  // share of the I-Regions' area that lies in their own cells, on the canvas
    double canvas_filled = 0;   // share of the canvas that shows real pixels
};

/// Lays out some items from scratch, with cells.
/// @param request  its items are taken from `items`
PlanResult plan_named(std::vector<NamedItem> items, PlanRequest request);

/// The same for a layout that exists. @pre layout.placements is as long as items
PlanResult plan_result(std::vector<NamedItem> items, Layout layout, const CellStyle& style = {});

/// {"size":[w,h], "energy":e, "items":[{"path":p, "shot":i, "scale":s, "region":[[x,y],...],
/// "cell":[[x,y],...], "cell_parts":[...], "filler":[...]}], "region_visible":v, "canvas_filled":f} in canvas
/// px, on one line. "cell_parts" holds what a cell shows apart from "cell"; it and "filler" stand only where
/// there are any. Bytes of a path that are not UTF-8 become U+FFFD.
std::string plan_json(const PlanResult& result);

/// A picture of the plan: cells filled by colour, filler hatched, I-Regions, outlines of the frames, order
/// numbers, the energy.
std::string plan_svg(const PlanResult& result);

}  // namespace vitrine::player
