#pragma once

#include <opencv2/core.hpp>

#include <cstdint>
#include <vector>

namespace vitrine::analyzer {

/// The picture to carve, and its properties; all of one size.
struct CarveInput {
    enum Given : std::uint8_t { open, stays, goes };

    cv::Mat picture;  // CV_8UC3
    cv::Mat bricks;   // CV_16SC1: each pixel's brick
    cv::Mat loss;     // CV_32FC1: cost of losing a pixel besides that of the new edge, squared grey levels
    cv::Mat given;    // CV_8UC1 of Given, or empty; a column is open wholly or not at all
};

/// The rows of a picture that remain, for each column by itself.
struct KeptRows {
    int columns = 0;
    int height = 0;                  // rows that remain
    std::vector<std::int16_t> rows;  // column by column, rising

    int at(int x, int y) const {
        return rows[static_cast<std::size_t>(x) * static_cast<std::size_t>(height) +
                    static_cast<std::size_t>(y)];
    }
};

/// Removes seams that run from left to right until the picture is `height` tall, each time the cheapest one.
/// A seam costs the squared edges that it makes and the loss of its pixels. From column to column it moves by
/// at most a row up or down. Where the brick changes it may come from anywhere, because nothing is torn
/// there.
/// Source: Rubinstein, Shamir, Avidan 2008 (forward energy). Differs: differences are squared, as in eq. 1 of
/// Video Tapestries.
///
/// @param height  at least 1; in columns that are not open, the number of pixels that stay
KeptRows carved(const CarveInput& input, int height);

/// The picture with the kept rows only. CV_8UC3.
cv::Mat picture_of(const cv::Mat& picture, const KeptRows& kept);

}  // namespace vitrine::analyzer
