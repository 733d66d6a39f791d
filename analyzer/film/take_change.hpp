#pragma once

#include "analyzer/film/feature_window.hpp"

namespace vitrine::analyzer {

/// So long after a frame is looked for what was seen before it: whatever hid it is gone by then.
constexpr std::chrono::milliseconds longest_return{1000};

enum class TakeChange { none, likely, clear };

/// Whether what follows a change shows something else than what went before it: no picture up to
/// longest_return after it shows, moved or not, what one shortly before showed. A flash, something passing
/// close by or a change of light is none.
///
/// @param before  the last frame before the change
/// @param after   the first frame after it
TakeChange take_change(const FeatureWindow& window, std::size_t before, std::size_t after);

/// The kind of change from one picture to another between two frames.
struct GradualChange {
    double share = 0;    // unexplained between both ends
    double area = 0;     // share of the picture in which something is
    double unmoved = 0;  // share of the change on the way that no motion explains: small for a pan
    double on_way = 0;   // unexplained on the way, step by step, as a share of that between both ends
};

GradualChange gradual_change(const FeatureWindow& window, std::size_t first, std::size_t last);

/// Says if take_change() is likely or clear.
bool is_new_take(const FeatureWindow& window, std::size_t before, std::size_t after);

}  // namespace vitrine::analyzer
