#pragma once

#include "analyzer/faces/face_detector.hpp"

#include <opencv2/dnn.hpp>

namespace vitrine::analyzer {

/// A small convolutional face detector; finds side faces, small ones and animals too.
/// Source: YuNet (S. Yu et al.), the ONNX of libfacedetection.train with a fixed input shape; decoded here
/// because FaceDetectorYN of OpenCV 4.6 expects other outputs.
class YuNet : public FaceDetector {
  public:
    /// @throws std::runtime_error if the model cannot be read
    explicit YuNet(const std::string& model);

    std::vector<Face> detect(const cv::Mat& bgr) override;

  private:
    cv::dnn::Net net_;
};

}  // namespace vitrine::analyzer
