#pragma once

#include "analyzer/film/frame_features.hpp"

namespace vitrine::analyzer {

/// The part of a picture that no motion from an earlier one explains.
struct Unexplained {
    double share =
        0;  // about 0 for two views of one scene, also of a moving one; about .2 to 1 for unlike pictures
    double area = 0;   // share of the picture in which something is left
    double still = 0;  // the share without motion
};

/// Blocks of `after` are sought in `before` within an eighth of the picture's width; what is left of them is
/// set against what two unrelated pictures of such contrast would leave.
Unexplained unexplained(const FrameFeatures& before, const FrameFeatures& after);

}  // namespace vitrine::analyzer
