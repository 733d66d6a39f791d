#include "player/layout/plan/plan_output.hpp"

#include "player/layout/cells/grid.hpp"

#include <utility>

namespace vitrine::player {

namespace {

Loops to_loops(std::span<const Polygon> polygons) {
    Loops loops;
    loops.reserve(polygons.size());
    for (const Polygon& polygon : polygons)
        loops.push_back(to_grid(polygon));
    return loops;
}

}  // namespace

PlanResult plan_result(std::vector<NamedItem> items, Layout layout, const CellStyle& style) {
    std::vector<LayoutItem> bare;
    bare.reserve(items.size());
    for (const NamedItem& item : items)
        bare.push_back(item.item);
    PlanResult result{.items = std::move(items), .layout = std::move(layout)};
    result.cells = cells(bare, result.layout, style);
    double whole = 0;
    double visible = 0;
    double filled = 0;
    for (std::size_t i = 0; i < bare.size(); ++i) {
        const Loops region{to_grid(placed_region(bare[i], result.layout.placements[i]))};
        const Loops parts = to_loops(result.cells[i].parts);
        whole += area_of(region);
        visible += area_of(intersection_of(region, parts));
        filled += area_of(parts);
    }
    if (whole > 0) result.region_visible = visible / whole;
    result.canvas_filled = filled / (result.layout.canvas.x * result.layout.canvas.y);
    return result;
}

PlanResult plan_named(std::vector<NamedItem> items, PlanRequest request) {
    request.items.clear();
    for (const NamedItem& item : items)
        request.items.push_back({.item = item.item});
    Layout layout = plan(request);
    return plan_result(std::move(items), std::move(layout));
}

}  // namespace vitrine::player
