#pragma once

#include "analyzer/saliency/saliency_map.hpp"

#include <opencv2/dnn.hpp>

#include <span>
#include <string>

namespace vitrine::analyzer {

constexpr int full_side = 320;  // px, of the square input of U2-Net's models

/// An ONNX model with the input of SaliencyNetwork becomes one for smaller pictures, with the same weights.
/// It takes time by the square of the side. Another model, whose input is not told so, stays as it is.
/// @param model  the bytes of the file
/// @param side   px, a multiple of 32, from 128 to full_side
std::string with_input_side(std::string model, int side);

/// A neural network that finds the subject of a picture: one square input of RGB with the means and
/// deviations of ImageNet, whose first output is one map. U2-Net and its small form are such.
class SaliencyNetwork {
  public:
    /// @param file  ONNX
    /// @param side  px, of its input
    /// @throws std::runtime_error if it cannot be read
    explicit SaliencyNetwork(const std::string& file, int side = full_side);

    /// @param file   name of the model, for errors
    /// @param model  ONNX, by with_input_side()
    /// @param side   px, of its input
    /// @throws std::runtime_error if it cannot be read
    SaliencyNetwork(std::string file, std::span<const char> model, int side);

    /// U2-Net's small form takes about a second of processor time at the full side, its student .03 s.
    /// @param bgr  CV_8UC3, not empty
    /// @return     for each pixel how likely it is the subject's, in [0, 1], of the input's size; stretched
    /// to
    ///             that range unless it is nearly the same everywhere
    /// @throws std::runtime_error if the network does not take such a picture or gives no map
    SaliencyMap map(const cv::Mat& bgr);

  private:
    std::string file_;
    cv::dnn::Net net_;
    int side_ = full_side;
    std::string output_;  // name of the first output
};

}  // namespace vitrine::analyzer
