#include "player/scene/acts/act_fields.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double min_scale = 1e-4;
constexpr double max_scale = 1e3;
constexpr double max_canvas_side = 16384;  // px

/// The numbers of an array of this length.
const ActJson& row_in(const ActJson& json, std::size_t length) {
    if (!json.is_array() || json.size() != length)
        throw ActFault(fmt::format("an act has no row of {} numbers where one belongs", length));
    return json;
}

}  // namespace

const ActJson& array_in(const ActJson& json, const char* key, std::size_t most) {
    const ActJson& array = json.at(key);
    if (!array.is_array() || array.size() > most)
        throw ActFault(fmt::format("an act's '{}' is no list, or has more than {} entries", key, most));
    return array;
}

double number_in(const ActJson& value, double most) {
    if (!value.is_number()) throw ActFault("an act has no number where one belongs");
    const auto number = value.get<double>();
    if (!(std::abs(number) <= most)) throw ActFault(fmt::format("a number of an act is beyond {}", most));
    return number;
}

std::int64_t whole_of(const ActJson& value, const char* name, std::int64_t least, std::int64_t most) {
    const bool fits = value.is_number_unsigned() ? std::in_range<std::int64_t>(value.get<std::uint64_t>())
                                                 : value.is_number_integer();
    const std::int64_t number = fits ? value.get<std::int64_t>() : 0;
    if (!fits || number < least || number > most)
        throw ActFault(fmt::format("an act's '{}' is no whole number from {} to {}", name, least, most));
    return number;
}

std::int64_t whole_in(const ActJson& json, const char* key, std::int64_t least, std::int64_t most) {
    return whole_of(json.at(key), key, least, most);
}

std::chrono::nanoseconds time_in(const ActJson& json, const char* key) {
    constexpr std::int64_t farthest = std::numeric_limits<std::int64_t>::max() / 4;  // sums stay in range
    return std::chrono::nanoseconds(whole_in(json, key, -farthest, farthest));
}

ActJson to_act_json(Vec2 v) {
    return ActJson::array({v.x, v.y});
}

ActJson to_act_json(const Box& box) {
    return ActJson::array({box.min.x, box.min.y, box.max.x, box.max.y});
}

ActJson to_act_json(const Placement& placement) {
    return ActJson::array({placement.scale, placement.offset.x, placement.offset.y});
}

ActJson to_act_json(const Polygon& polygon) {
    ActJson json = ActJson::array();
    for (const Vec2 corner : polygon) {
        json.push_back(corner.x);
        json.push_back(corner.y);
    }
    return json;
}

Vec2 vec2_in(const ActJson& json) {
    const ActJson& row = row_in(json, 2);
    return {number_in(row[0]), number_in(row[1])};
}

Vec2 canvas_in(const ActJson& json) {
    const Vec2 canvas = vec2_in(json);
    if (canvas.x < 1 || canvas.y < 1 || canvas.x > max_canvas_side || canvas.y > max_canvas_side)
        throw ActFault("the canvas of an act has no size, or is too large");
    return canvas;
}

Box box_in(const ActJson& json) {
    const ActJson& row = row_in(json, 4);
    return {{number_in(row[0]), number_in(row[1])}, {number_in(row[2]), number_in(row[3])}};
}

Placement placement_in(const ActJson& json) {
    const ActJson& row = row_in(json, 3);
    const Placement placement{number_in(row[0]), {number_in(row[1]), number_in(row[2])}};
    if (!(placement.scale >= min_scale && placement.scale <= max_scale))
        throw ActFault("an act places a shot so large or so small that it cannot be drawn");
    return placement;
}

Polygon polygon_in(const ActJson& json) {
    if (!json.is_array() || json.size() % 2 != 0 || json.size() > 2 * max_act_corners)
        throw ActFault("an outline of an act is no list of corners, or has too many");
    Polygon polygon;
    for (std::size_t k = 0; k < json.size(); k += 2)
        polygon.push_back({number_in(json[k]), number_in(json[k + 1])});
    return polygon;
}

}  // namespace vitrine::player
