#pragma once

#include "analyzer/network/network.hpp"
#include "analyzer/saliency/saliency_map.hpp"

#include <memory>

namespace vitrine::analyzer {

constexpr int full_side = 320;    // px, of the square input that the files of U2-Net's models declare
constexpr int coarse_side = 160;  // px, of a quick look, and of the square input that the student declares

/// The input of a network for a picture: it has the picture's shape, in steps of 32 px, which the stages of
/// U2-Net need, and about as many px as a square of this side. In a square, things of a wide picture would be
/// narrow.
/// @param picture  not empty
/// @param side     px
cv::Size look_size(cv::Size picture, int side);

/// A neural network that finds the subject of a picture: one input of RGB with the means and deviations of
/// ImageNet, whose first output is one map. U2-Net, its small form and its student are such.
class SaliencyNetwork {
  public:
    /// @param network  of a model whose input is declared as a square of full_side or coarse_side. Another
    ///                 model takes squares of this side only. Not null; looks of several sides may share one
    /// @param side     px, as in look_size(); a look takes time by its square
    SaliencyNetwork(std::shared_ptr<Network> network, int side);

    /// True if the network takes pictures of other sizes than the declared one.
    bool is_scalable() const { return network_->declares_square(); }

    /// U2-Net's small form takes about .4 s of processor time at the full side, its student .03 s at the
    /// coarse one. The first look, and each at a picture of another shape than the one before, also prepares
    /// the model.
    /// @param bgr  CV_8UC3, not empty
    /// @return     for each pixel how likely it is the subject's, of the input's size. The values are
    ///             stretched to [0, 1], unless they are nearly the same everywhere
    /// @throws std::runtime_error if OpenCV cannot use the model, or it gives no map of such a picture
    SaliencyMap map(const cv::Mat& bgr);

  private:
    std::shared_ptr<Network> network_;
    int side_ = full_side;
};

}  // namespace vitrine::analyzer
