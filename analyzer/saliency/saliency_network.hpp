#pragma once

#include "analyzer/saliency/saliency_map.hpp"

#include <opencv2/dnn.hpp>

#include <string>

namespace vitrine::analyzer {

/// A neural network that finds the subject of a picture: one input of 1 x 3 x 320 x 320, RGB with the means
/// and deviations of ImageNet, whose first output is one map. U2-Net and its small form are such.
class SaliencyNetwork {
  public:
    /// @param file  ONNX
    /// @throws std::runtime_error if it cannot be read
    explicit SaliencyNetwork(const std::string& file);

    /// Takes about a second of processor time.
    /// @param bgr  CV_8UC3, not empty
    /// @return     for each pixel how likely it is the subject's, in [0, 1], of 320 x 320; stretched to that
    ///             range unless it is nearly the same everywhere
    /// @throws std::runtime_error if the network does not take such a picture or gives no map
    SaliencyMap map(const cv::Mat& bgr);

  private:
    std::string file_;
    cv::dnn::Net net_;
};

}  // namespace vitrine::analyzer
