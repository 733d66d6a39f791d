#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"
#include "player/layout/layout.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace vitrine::player {

/// Thrown for a text that is no act. The message is a sentence for the operator.
struct ActFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The fields of acts, written so that they are read as the same bits, and read within bounds. All readers
// throw ActFault or nlohmann::json::exception.

using ActJson = nlohmann::json;

constexpr double max_act_length = 1e6;         // px, of places on the canvas and in pictures
constexpr double max_ribbon_length = 1e12;     // px, of the way of a panning wall
constexpr std::size_t max_act_shots = 400;     // on one wall
constexpr std::size_t max_act_corners = 4000;  // of one cell
constexpr std::size_t max_act_keys = 64;       // moments on a way

/// The array in a field. @throws ActFault naming the field, if it has more entries
const ActJson& array_in(const ActJson& json, const char* key, std::size_t most);

/// A number whose magnitude is at most `most`.
double number_in(const ActJson& value, double most = max_act_length);

/// A whole number within bounds. @param name  the value's name in the fault
std::int64_t whole_of(const ActJson& value, const char* name, std::int64_t least, std::int64_t most);

std::int64_t whole_in(const ActJson& json, const char* key, std::int64_t least, std::int64_t most);

std::chrono::nanoseconds time_in(const ActJson& json, const char* key);

ActJson to_act_json(Vec2 v);
ActJson to_act_json(const Box& box);
ActJson to_act_json(const Placement& placement);
ActJson to_act_json(const Polygon& polygon);

Vec2 vec2_in(const ActJson& json);

/// The size of a canvas that can be drawn, px.
Vec2 canvas_in(const ActJson& json);

Box box_in(const ActJson& json);

/// A placement with a scale that can be drawn.
Placement placement_in(const ActJson& json);

Polygon polygon_in(const ActJson& json);

}  // namespace vitrine::player
