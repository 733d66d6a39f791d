#pragma once

#include "analyzer/network/convolution.hpp"

#include <span>
#include <vector>

namespace vitrine::analyzer {

/// A convolution of each plane by weights of its own, 3 x 3 or 5 x 5.
class DepthwiseConvolution : public Convolution {
  public:
    /// @param weights  planes x side x side; the side is odd
    /// @param biases   one for each plane
    DepthwiseConvolution(std::span<const float> weights, std::span<const float> biases);

    void run(const float* planes, PlaneSize size, Activation activation, float* result) const override;

  private:
    int side_ = 0;  // px
    std::vector<float> weights_;
    std::vector<float> biases_;
};

}  // namespace vitrine::analyzer
