#include "player/scene/acts/cell_json.hpp"

#include "player/layout/cells/grid.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double max_whole = 1e15;  // a double holds it exactly
constexpr double max_width = 1e4;   // px of a feather
constexpr std::size_t max_outlines = 2000;
constexpr std::size_t max_triangles = 2 * max_act_corners;

/// A multiple of the grid's step, which a double multiplies exactly.
ActJson step_json(double px) {
    const double steps = px * cell_grid;
    if (steps == std::floor(steps) && std::abs(steps) < max_whole && !(steps == 0 && std::signbit(steps)))
        return static_cast<std::int64_t>(steps);
    return steps;
}

/// The corners of a cell, each once, with their numbers.
class Corners {
  public:
    std::size_t number_of(Vec2 corner) {
        const auto [place, is_new] = numbers_.try_emplace(
            {std::bit_cast<std::uint64_t>(corner.x), std::bit_cast<std::uint64_t>(corner.y)},
            numbers_.size());
        if (is_new) {
            json.push_back(step_json(corner.x));
            json.push_back(step_json(corner.y));
        }
        return place->second;
    }

    ActJson numbers_of(std::span<const Vec2> outline) {
        ActJson numbers = ActJson::array();
        for (const Vec2 corner : outline)
            numbers.push_back(number_of(corner));
        return numbers;
    }

    ActJson numbers_of(const std::vector<Polygon>& outlines) {
        ActJson numbers = ActJson::array();
        for (const Polygon& outline : outlines)
            numbers.push_back(numbers_of(std::span<const Vec2>(outline)));
        return numbers;
    }

    ActJson numbers_of(const std::vector<std::array<Vec2, 3>>& triangles) {
        ActJson numbers = ActJson::array();
        for (const std::array<Vec2, 3>& triangle : triangles)
            for (const Vec2 corner : triangle)
                numbers.push_back(number_of(corner));
        return numbers;
    }

    ActJson json = ActJson::array();

  private:
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> numbers_;
};

Polygon corners_in(const ActJson& json) {
    const ActJson& steps = array_in(json, "corners", 2 * max_act_corners);
    if (steps.size() % 2 != 0) throw ActFault("a cell of an act has half a corner");
    Polygon corners;
    for (std::size_t k = 0; k < steps.size(); k += 2)
        corners.push_back({number_in(steps[k], max_act_length * cell_grid) / cell_grid,
                           number_in(steps[k + 1], max_act_length * cell_grid) / cell_grid});
    return corners;
}

Vec2 corner_in(const ActJson& number, const Polygon& corners) {
    if (!number.is_number_unsigned() || number.get<std::uint64_t>() >= corners.size())
        throw ActFault("a cell of an act names a corner that it does not have");
    return corners[number.get<std::size_t>()];
}

Polygon outline_in(const ActJson& numbers, const Polygon& corners) {
    if (!numbers.is_array() || numbers.size() < 3 || numbers.size() > max_act_corners)
        throw ActFault("an outline of a cell of an act has less than three corners, or too many");
    Polygon outline;
    for (const ActJson& number : numbers)
        outline.push_back(corner_in(number, corners));
    return outline;
}

std::vector<Polygon> outlines_in(const ActJson& json, const char* key, const Polygon& corners) {
    std::vector<Polygon> outlines;
    for (const ActJson& numbers : array_in(json, key, max_outlines))
        outlines.push_back(outline_in(numbers, corners));
    return outlines;
}

std::vector<std::array<Vec2, 3>> triangles_in(const ActJson& json, const char* key, const Polygon& corners) {
    const ActJson& numbers = array_in(json, key, 3 * max_triangles);
    if (numbers.size() % 3 != 0) throw ActFault("a cell of an act has a triangle without three corners");
    std::vector<std::array<Vec2, 3>> triangles;
    for (std::size_t k = 0; k < numbers.size(); k += 3)
        triangles.push_back({corner_in(numbers[k], corners), corner_in(numbers[k + 1], corners),
                             corner_in(numbers[k + 2], corners)});
    return triangles;
}

FadeEdge edge_in(const ActJson& json, const Polygon& corners) {
    FadeEdge edge{.outline = outline_in(json.at("outline"), corners), .widths = {}};
    for (const ActJson& width : array_in(json, "widths", max_act_corners))
        edge.widths.push_back(number_in(width, max_width));
    if (edge.widths.size() != edge.outline.size())
        throw ActFault("an edge of a cell of an act has not one width for each corner");
    return edge;
}

}  // namespace

ActJson cell_to_json(const Cell& cell) {
    Corners corners;
    ActJson json{{"parts", corners.numbers_of(cell.parts)},
                 {"filler", corners.numbers_of(cell.filler)},
                 {"triangles", corners.numbers_of(cell.triangles)},
                 {"filler_triangles", corners.numbers_of(cell.filler_triangles)},
                 {"coverage", cell.edge_coverage}};
    ActJson edges = ActJson::array();
    for (const FadeEdge& edge : cell.fade_edges)
        edges.push_back(
            {{"outline", corners.numbers_of(std::span<const Vec2>(edge.outline))}, {"widths", edge.widths}});
    json["edges"] = std::move(edges);
    json["corners"] = std::move(corners.json);
    return json;
}

Cell cell_from_json(const ActJson& json) {
    const Polygon corners = corners_in(json);
    Cell cell{.parts = outlines_in(json, "parts", corners),
              .filler = outlines_in(json, "filler", corners),
              .triangles = triangles_in(json, "triangles", corners),
              .filler_triangles = triangles_in(json, "filler_triangles", corners),
              .fade_edges = {},
              .edge_coverage = number_in(json.at("coverage"), 1)};
    for (const ActJson& edge : array_in(json, "edges", max_outlines))
        cell.fade_edges.push_back(edge_in(edge, corners));
    return cell;
}

}  // namespace vitrine::player
