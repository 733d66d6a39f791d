#pragma once

#include "analyzer/film/frame_features.hpp"

namespace vitrine::analyzer {

/// The part of a picture that no motion from an earlier one explains.
struct Unexplained {
    /// About 0 for two views of one scene, also of a moving one; about .2 to 1 for unlike pictures.
    double share = 0;
    double area = 0;   // share of the picture in which something is left unexplained
    double still = 0;  // `share` if nothing were to move
};

/// Searches the blocks of `after` in `before` within an eighth of the picture's width. The difference that is
/// left is divided by that of two unrelated pictures of such contrast.
Unexplained unexplained(const FrameFeatures& before, const FrameFeatures& after);

}  // namespace vitrine::analyzer
