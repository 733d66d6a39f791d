#pragma once

#include "analyzer/film/feature_window.hpp"

namespace vitrine::analyzer {

/// The mean change of hue, saturation and value between two frames within their common part, in [0, 255]. Hue
/// counts as much as both places are coloured, saturation as much as they are bright.
double content_change(const FrameFeatures& before, const FrameFeatures& after);

/// A second vote on a cut, for pictures that motion seems to explain: a blurred one, or two under the same
/// title. Says if the content changes far more than from frame to frame around, and for longer than a flash.
///
/// Source: the adaptive content detector of PySceneDetect. Differs: a change that is undone soon, a pan that
/// starts and a change of light do not count.
bool is_sudden_change(const FeatureWindow& window, std::size_t frame);

}  // namespace vitrine::analyzer
