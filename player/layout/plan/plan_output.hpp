#pragma once

#include "player/layout/cells/cells.hpp"
#include "player/layout/layout.hpp"

#include <string>
#include <vector>

namespace vitrine::player {

/// An item of a plan and its file.
struct NamedItem {
    std::string path;  // relative to the media folder, any bytes
    std::size_t shot = 0;
    LayoutItem item;
};

/// A layout with its cells and measures.
struct PlanResult {
    std::vector<NamedItem> items;
    Layout layout;
    std::vector<Cell> cells;
    double region_visible = 1;  // share of the I-Regions' area inside their own cells, on the canvas
    double canvas_filled = 0;   // share of the canvas with real pixels
};

/// Computes the cells of a layout and measures it. @pre one placement for each item
PlanResult plan_result(std::vector<NamedItem> items, Layout layout, const CellStyle& style = {});

/// {"size":[w,h], "energy":e, "items":[{"path":p, "shot":i, "scale":s, "region":[[x,y],...],
/// "cell":[[x,y],...], "cell_parts":[...], "filler":[...]}], "region_visible":v, "canvas_filled":f} in canvas
/// px, on one line. "cell_parts" has the parts of a cell besides "cell". It and "filler" are left out if
/// empty. Bytes of a path that are not UTF-8 become U+FFFD.
std::string plan_json(const PlanResult& result);

/// A picture of the plan: cells filled by colour, filler hatched, I-Regions, outlines of the frames, order
/// numbers, hulls of the groups, the energy.
std::string plan_svg(const PlanResult& result);

}  // namespace vitrine::player
