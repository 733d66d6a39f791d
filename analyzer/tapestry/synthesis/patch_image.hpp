#pragma once

#include <opencv2/core.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine::analyzer {

constexpr int patch_side = 7;                              // px; source: Video Tapestries 3
constexpr int patch_values = 3 * patch_side * patch_side;  // channel values of a patch
constexpr int patch_row_bytes = 4 * patch_side;

/// A picture whose patches are compared: B, G, R and 1 for each pixel, in one piece of memory with some
/// readable bytes behind it. The 1 makes sums of votes count the votes, too.
class PatchImage {
  public:
    PatchImage() = default;
    PatchImage(int width, int height);

    /// @param bgr  CV_8UC3
    explicit PatchImage(const cv::Mat& bgr);

    int width() const { return width_; }

    int height() const { return height_; }

    /// The numbers of patches beside and below each other. A patch is named by the place of its upper left
    /// pixel.
    int patch_columns() const { return width_ - patch_side + 1; }

    int patch_rows() const { return height_ - patch_side + 1; }

    std::size_t stride() const { return 4 * static_cast<std::size_t>(width_); }

    std::uint8_t* at(int x, int y) {
        return &bytes_[static_cast<std::size_t>(y) * stride() + 4 * static_cast<std::size_t>(x)];
    }

    const std::uint8_t* at(int x, int y) const {
        return &bytes_[static_cast<std::size_t>(y) * stride() + 4 * static_cast<std::size_t>(x)];
    }

    /// CV_8UC3.
    cv::Mat bgr() const;

  private:
    int width_ = 0;
    int height_ = 0;
    std::vector<std::uint8_t> bytes_;
};

/// The sum of squared differences of two patches' channel values, [0, 147 * 255^2]. A sum beyond `bound` may
/// be any value beyond `bound`.
using PatchDistance = int (*)(const std::uint8_t* a, std::size_t a_stride, const std::uint8_t* b,
                              std::size_t b_stride, int bound);

/// The fastest implementation for this processor; all return the same values.
PatchDistance patch_distance();

}  // namespace vitrine::analyzer
