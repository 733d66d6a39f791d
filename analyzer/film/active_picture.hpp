#pragma once

#include <opencv2/core.hpp>

#include <array>
#include <chrono>
#include <deque>
#include <optional>
#include <vector>

namespace vitrine::analyzer {

/// A band of one colour along one side of a picture.
struct SideBand {
    int depth = 0;       // px from the side; rows that hold nothing but the colour
    double edge = 0;     // share of its inner edge between the bands beside it, in [0, 1], along which
                         // another colour follows at once
    double side = 0;     // the same edge as a share of the whole side
    cv::Vec3b colour{};  // BGR

    bool operator==(const SideBand&) const = default;
};

enum class Side { left, top, right, bottom };

/// The bands at the four sides of one picture, by Side.
using SideBands = std::array<SideBand, 4>;

/// @param bgr  CV_8UC3, not empty
SideBands side_bands(const cv::Mat& bgr);

/// Finds the active picture: the part of a medium's pictures within its bars, shot by shot. Bars keep their
/// place and their one colour over a whole shot, lie at two opposite sides, and end in a straight line. A
/// dark sky has no straight edge, nor has a title on a black ground. A shot so dark that its bars show no
/// edge takes the bars of other shots, where it is dark there too. A photo is one shot of one picture.
class ActivePictureFinder {
  public:
    /// @param bgr  CV_8UC3, not empty, of one size for the whole film
    void add_picture(const cv::Mat& bgr, std::chrono::nanoseconds time);

    /// The active picture of the newest picture, as far as it is known before its shot is over, px.
    cv::Rect newest() const;

    /// The active picture of a shot that is over, px. Forgets the pictures before its end.
    cv::Rect close_shot(std::chrono::nanoseconds begin, std::chrono::nanoseconds end);

    /// The active pictures of all closed shots in their order, now that all shots are known.
    std::vector<cv::Rect> all_shots() const;

    /// The pictures with their bars, px.
    cv::Rect whole() const { return {{0, 0}, size_}; }

  private:
    struct Seen {
        std::chrono::nanoseconds time;
        SideBands bands;
    };

    /// A closed shot: its bars, or how deep they may be.
    struct Closed {
        std::optional<cv::Rect> found;  // none: no bars with a straight edge
        std::array<int, 4> depths{};    // px, by Side: the rows of one colour in all its pictures
        std::chrono::nanoseconds duration{0};
    };

    std::optional<cv::Rect> usual_bars() const;
    cv::Rect active_picture(const Closed& shot) const;

    cv::Size size_;
    std::deque<Seen> seen_;
    std::vector<Closed> closed_;
};

}  // namespace vitrine::analyzer
