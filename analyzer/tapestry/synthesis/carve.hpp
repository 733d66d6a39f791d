#pragma once

#include <opencv2/core.hpp>

#include <cstdint>
#include <vector>

namespace vitrine::analyzer {

/// The pictures that become less tall; all of one size.
struct CarveInput {
    enum Given : std::uint8_t { open, stays, goes };

    cv::Mat picture;  // CV_8UC3
    cv::Mat bricks;   // CV_16SC1: the brick that a pixel is of
    cv::Mat loss;     // CV_32FC1: what losing a pixel costs beyond the edge it makes, squared grey levels
    cv::Mat given;    // CV_8UC1 of Given, or empty; a column is open as a whole or not at all
};

/// The rows of a picture that are left, for each column by itself.
struct KeptRows {
    int columns = 0;
    int height = 0;                  // rows left
    std::vector<std::int16_t> rows;  // column by column, rising

    int at(int x, int y) const {
        return rows[static_cast<std::size_t>(x) * static_cast<std::size_t>(height) +
                    static_cast<std::size_t>(y)];
    }
};

/// Takes seams from left to right out of a picture until it is `height` tall, each the one that costs least:
/// the squared edges that it brings together and what it loses. A seam goes at most a row up or down from
/// column to column, and anywhere where the brick changes, as nothing is torn there.
/// Source: Rubinstein, Shamir, Avidan 2008 (forward energy). Differs: squared differences, as eq. 1 counts.
///
/// @param height  at least 1; in columns that are given, so many stay
KeptRows carved(const CarveInput& input, int height);

/// The picture of the rows that are left. CV_8UC3.
cv::Mat picture_of(const cv::Mat& picture, const KeptRows& kept);

}  // namespace vitrine::analyzer
