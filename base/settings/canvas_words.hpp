#pragma once

#include "base/geometry/vec2.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// The place of an output on the canvas. Lengths are in the unit of the canvas, x to the right, y down.
struct OutputPlace {
    std::string output;         // the connector's name: "HDMI-A-1"
    Vec2 at;                    // its top left corner as it hangs
    std::optional<Vec2> size;   // of its picture as it hangs; none: as many units as it has px
    std::optional<int> turned;  // degrees clockwise by which it hangs turned; none: output.rotation

    bool operator==(const OutputPlace&) const = default;
};

/// The outputs that show parts of one canvas.
struct CanvasWords {
    std::vector<OutputPlace> places;  // none: there is no such canvas
    std::string fault;  // empty: the text is understood; else a sentence that says what is wrong

    bool operator==(const CanvasWords&) const = default;
};

/// Parses a canvas: "HDMI-A-1 0,0; HDMI-A-2 1960,0" in pixels, or "mm: HDMI-A-1 0,0 698x393; HDMI-A-2 0,420
/// 698x393 turned 180". Each output has its place, perhaps its size, perhaps its turn. Empty: no canvas.
CanvasWords canvas_named(std::string_view text);

}  // namespace vitrine
