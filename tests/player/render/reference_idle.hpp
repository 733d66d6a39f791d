#pragma once

#include "base/geometry/vec2.hpp"
#include "tests/player/render/reference_picture.hpp"

#include <array>
#include <chrono>
#include <vector>

namespace vitrine::player {

/// A corner of the grid at which the idle picture is computed.
struct IdleCorner {
    Vec2 share;  // of the canvas' width and height
    Rgb colour{};
};

/// The idle picture of a canvas at a time, as triangles between whose corners the colours change evenly.
std::vector<std::array<IdleCorner, 3>> idle_triangles(Vec2 canvas, std::chrono::nanoseconds time);

}  // namespace vitrine::player
