#pragma once

#include "analyzer/network/convolution.hpp"

#include <span>
#include <vector>

namespace vitrine::analyzer {

/// A convolution by 1 x 1 weights: each value of the result is a sum over the inputs at the same pixel.
class PointwiseConvolution : public Convolution {
  public:
    /// @param weights  outputs x inputs
    /// @param biases   one for each output
    PointwiseConvolution(std::span<const float> weights, std::span<const float> biases);

    void run(const float* planes, PlaneSize size, Activation activation, float* result) const override;

  private:
    int inputs_ = 0;
    int outputs_ = 0;
    std::vector<float> weights_;  // groups of outputs x inputs x outputs of a group
    std::vector<float> biases_;   // one for each output of all groups
};

}  // namespace vitrine::analyzer
