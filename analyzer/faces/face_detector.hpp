#pragma once

#include "base/geometry/box.hpp"

#include <opencv2/core.hpp>

#include <vector>

namespace vitrine::analyzer {

struct Face {
    Box box;           // px of the picture searched
    double score = 0;  // (0, 1]
};

/// Finds faces in a picture. Viola-Jones is the paper's; YuNet finds more in less time where its model is at
/// hand.
class FaceDetector {
  public:
    FaceDetector() = default;
    FaceDetector(const FaceDetector&) = delete;
    FaceDetector& operator=(const FaceDetector&) = delete;
    virtual ~FaceDetector() = default;

    /// @param bgr  CV_8UC3, not empty
    virtual std::vector<Face> detect(const cv::Mat& bgr) = 0;
};

}  // namespace vitrine::analyzer
