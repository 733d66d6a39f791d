#pragma once

namespace vitrine::analyzer {

/// From now on the networks that OpenCV reads compute their convolutions by the classes of this folder, where
/// these take them: in steps of 1 px, with weights of 1 x 1 or 3 x 3, or of 3 x 3 or 5 x 5 for each plane
/// alone. OpenCV 4.6 takes two to ten times as long.
void use_fast_convolutions();

}  // namespace vitrine::analyzer
