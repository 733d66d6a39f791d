#pragma once

#include "analyzer/network/convolution.hpp"

#include <span>
#include <vector>

namespace vitrine::analyzer {

/// A convolution by 3 x 3 weights. It multiplies 2.25 times for each value of the result and each input,
/// where a plain convolution multiplies 9 times. The result differs from that by rounding: by less than a
/// ten-thousandth of the largest values. Source: Lavin, Gray, Fast Algorithms for Convolutional Neural
/// Networks, CVPR 2016: F(4x4, 3x3).
class WinogradConvolution : public Convolution {
  public:
    /// @param weights  outputs x inputs x 3 x 3
    /// @param biases   one for each output
    WinogradConvolution(std::span<const float> weights, std::span<const float> biases);

    void run(const float* planes, PlaneSize size, Activation activation, float* result) const override;

  private:
    int inputs_ = 0;
    int outputs_ = 0;
    std::vector<float> weights_;  // transformed: 36 x groups of outputs x inputs x outputs of a group
    std::vector<float> biases_;
};

}  // namespace vitrine::analyzer
