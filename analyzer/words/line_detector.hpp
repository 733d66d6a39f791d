#pragma once

#include "analyzer/network/network.hpp"
#include "base/geometry/box.hpp"

#include <opencv2/core.hpp>

#include <string>
#include <vector>

namespace vitrine::analyzer {

constexpr float line_core = 0.3F;  // values of the map from which a pixel is a line's core

/// Finds lines of text in a picture, whatever their script, by a neural network that marks the core of each
/// line. It reads nothing.
/// Source: Liao et al., Real-time Scene Text Detection with Differentiable Binarization, AAAI 2020; the
/// network is PP-OCRv4's small detector (analyzer/models).
class LineDetector {
  public:
    /// @param file  ONNX: one picture of any size in multiples of 32, one map of the same size
    /// @throws std::runtime_error if it cannot be read
    explicit LineDetector(const std::string& file);

    /// The cost grows with the area that is searched: 640 x 480 px take about a tenth of a second of
    /// processor time.
    /// @param bgr   CV_8UC3, not empty
    /// @param side  px, the longest side of what the network sees, a multiple of 32
    /// @return      boxes that hold a whole line each, px of `bgr`
    /// @throws std::runtime_error if the network does not take such a picture or gives no map
    std::vector<Box> find(const cv::Mat& bgr, int side);

    /// The network looks at a picture.
    /// @return  in px of what it sees, CV_32FC1 in [0, 1]: how likely each pixel is a line's core
    /// @throws std::runtime_error like find()
    cv::Mat map(const cv::Mat& bgr, int side);

  private:
    Network network_;
};

}  // namespace vitrine::analyzer
