#pragma once

namespace vitrine::analyzer {

/// One size for all planes.
struct PlaneSize {
    int height = 0;  // px
    int width = 0;   // px
};

/// A convolution changes each value of its result by one of these functions.
enum class Activation {
    none,
    rectified,   // negative values become 0
    hard_swish,  // x min(1, max(0, x / 6 + 1/2)). Source: Howard et al., Searching for MobileNetV3, ICCV 2019
};

/// A convolution of planes by weights that are known before, in steps of 1 px. A border of zeros keeps the
/// size of the planes.
class Convolution {
  public:
    Convolution() = default;
    virtual ~Convolution() = default;
    Convolution(const Convolution&) = delete;
    Convolution& operator=(const Convolution&) = delete;

    /// @param planes  one for each input, rows of px
    /// @param result  one plane for each output; does not overlap `planes`
    virtual void run(const float* planes, PlaneSize size, Activation activation, float* result) const = 0;
};

}  // namespace vitrine::analyzer
