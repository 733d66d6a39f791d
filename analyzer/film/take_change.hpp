#pragma once

#include "analyzer/film/feature_window.hpp"

namespace vitrine::analyzer {

/// Pictures from before a change are searched up to so long after it: whatever hid them is gone by then.
constexpr std::chrono::milliseconds max_return{1000};

enum class TakeChange { none, likely, clear };

/// Says if the pictures after a change show something else than those before it: up to max_return later
/// none shows, moved or not, the content of one shortly before. A flash, a close thing that passes or a
/// change of light is no new take.
///
/// @param before  the last frame before the change
/// @param after   the first frame after it
TakeChange take_change(const FeatureWindow& window, std::size_t before, std::size_t after);

/// The kind of change from one picture to another between two frames.
struct GradualChange {
    double share = 0;    // unexplained share between both ends
    double area = 0;     // share of the picture in which something is unexplained
    double unmoved = 0;  // share of the change on the way that no motion explains: small for a pan
    double on_way = 0;   // sum of the unexplained shares of all steps over that between both ends
};

GradualChange gradual_change(const FeatureWindow& window, std::size_t first, std::size_t last);

/// Says if take_change() is likely or clear.
bool is_new_take(const FeatureWindow& window, std::size_t before, std::size_t after);

}  // namespace vitrine::analyzer
