#pragma once

#include "analyzer/faces/face_detector.hpp"

#include <opencv2/objdetect.hpp>

namespace vitrine::analyzer {

/// The paper's face detector: a boosted cascade of Haar features; frontal faces only.
/// Source: Viola and Jones 2001, as Dynamic Media Assemblage 3.2 [26].
class ViolaJones : public FaceDetector {
  public:
    /// @throws std::runtime_error if the cascade cannot be read
    explicit ViolaJones(const std::string& cascade);

    /// Every face scores 1: the cascade has no confidence.
    std::vector<Face> detect(const cv::Mat& bgr) override;

  private:
    cv::CascadeClassifier cascade_;
};

}  // namespace vitrine::analyzer
