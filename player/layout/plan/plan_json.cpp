#include "player/layout/plan/plan_output.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace vitrine::player {

namespace {

using Json = nlohmann::ordered_json;

/// To 1/1000 px: short, and far below what can be seen.
Json to_json(const Polygon& polygon) {
    Json corners = Json::array();
    for (const Vec2& p : polygon)
        corners.push_back({std::round(p.x * 1000) / 1000, std::round(p.y * 1000) / 1000});
    return corners;
}

Json to_json(std::span<const Polygon> polygons) {
    Json list = Json::array();
    for (const Polygon& polygon : polygons)
        list.push_back(to_json(polygon));
    return list;
}

Json to_json(const NamedItem& item, const Placement& placement, const Cell& cell) {
    Json json{{"path", item.path}, {"shot", item.shot}, {"scale", placement.scale}};
    json["region"] = to_json(placed_region(item.item, placement));
    json["cell"] = cell.parts.empty() ? Json::array() : to_json(cell.parts[0]);
    if (cell.parts.size() > 1) json["cell_parts"] = to_json(std::span(cell.parts).subspan(1));
    if (!cell.filler.empty()) json["filler"] = to_json(cell.filler);
    return json;
}

}  // namespace

std::string plan_json(const PlanResult& result) {
    Json items = Json::array();
    for (std::size_t i = 0; i < result.items.size(); ++i)
        items.push_back(to_json(result.items[i], result.layout.placements[i], result.cells[i]));
    const Json json{{"size", {result.layout.canvas.x, result.layout.canvas.y}},
                    {"energy", result.layout.energy},
                    {"items", std::move(items)},
                    {"region_visible", result.region_visible},
                    {"canvas_filled", result.canvas_filled}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace vitrine::player
