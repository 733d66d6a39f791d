#include "player/layout/plan/plan_output.hpp"

#include "base/geometry/convex_hull.hpp"
#include "player/layout/cells/grid.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iterator>
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

using Json = nlohmann::ordered_json;

/// Rounds to 1/1000 px: short text, and far below visible differences.
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

using Text = std::back_insert_iterator<std::string>;

/// Hues a golden angle apart, so that neighbours in the order have different colours.
std::string colour(std::size_t item, int lightness) {
    const double hue = 137.508 * static_cast<double>(item);
    return fmt::format("hsl({:.0f},55%,{}%)", hue - 360 * static_cast<int>(hue / 360), lightness);
}

std::string points(const Polygon& polygon) {
    std::string text;
    for (const Vec2& p : polygon)
        fmt::format_to(std::back_inserter(text), "{:.3f},{:.3f} ", p.x, p.y);
    return text;
}

void draw_cell(Text out, const Cell& cell, std::size_t item) {
    const std::string line = "stroke='#fff' stroke-width='1'";
    for (const Polygon& part : cell.parts)
        fmt::format_to(out, "<polygon points='{}' fill='{}' {}/>\n", points(part), colour(item, 78), line);
    for (const Polygon& part : cell.filler)
        fmt::format_to(out,
                       "<polygon points='{0}' fill='{1}' {2}/><polygon points='{0}' fill='url(#filler)'/>\n",
                       points(part), colour(item, 60), line);
}

void draw_item(Text out, const NamedItem& item, const Placement& placement, std::size_t number) {
    const Polygon region = placed_region(item.item, placement);
    const Polygon frame = transformed(to_polygon(item.item.core), placement.scale, placement.offset);
    fmt::format_to(out, "<polygon points='{}' fill='none' stroke='{}' stroke-dasharray='6 6'/>\n",
                   points(frame), colour(number, 45));
    fmt::format_to(out, "<polygon points='{}' fill='{}' stroke='#b00' stroke-width='1.5'/>\n", points(region),
                   colour(number, 50));
    if (region.empty()) return;
    const Vec2 middle = centroid(region);
    fmt::format_to(out, "<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>\n", middle.x,
                   middle.y + 9, number + 1);
}

void draw_group(Text out, const PlanResult& result, const LayoutGroup& group) {
    std::vector<Vec2> corners;
    for (const std::size_t i : group.items)
        for (const Vec2& p : placed_region(result.items[i].item, result.layout.placements[i]))
            corners.push_back(p);
    fmt::format_to(out, "<polygon points='{}' fill='none' stroke='#036' stroke-width='4'/>\n",
                   points(convex_hull(corners)));
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

std::string plan_svg(const PlanResult& result) {
    const Vec2 size = result.layout.canvas;
    std::string svg;
    const auto out = std::back_inserter(svg);
    fmt::format_to(out,
                   "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}' "
                   "font-family='sans-serif' font-size='26'>\n"
                   "<pattern id='filler' width='8' height='8' patternUnits='userSpaceOnUse'>"
                   "<path d='M0 8L8 0' stroke='#000' stroke-opacity='.5'/></pattern>\n"
                   "<rect width='{0}' height='{1}' fill='#000'/>\n",
                   size.x, size.y);
    for (std::size_t i = 0; i < result.cells.size(); ++i)
        draw_cell(out, result.cells[i], i);
    for (std::size_t i = 0; i < result.items.size(); ++i)
        draw_item(out, result.items[i], result.layout.placements[i], i);
    for (const LayoutGroup& group : result.layout.groups)
        draw_group(out, result, group);
    fmt::format_to(
        out,
        "<text x='12' y='{:.0f}' font-size='18'>energy {:.4f}, regions visible {:.4f}, canvas filled "
        "{:.4f}</text>\n</svg>\n",
        size.y - 10, result.layout.energy, result.region_visible, result.canvas_filled);
    return svg;
}

}  // namespace vitrine::player
