#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"

#include <opencv2/core.hpp>

#include <string>
#include <string_view>

namespace vitrine::analyzer {

/// 0xRRGGBB.
using Ink = unsigned;

enum class TextWeight { normal, bold };

/// A picture that is drawn on and written as PNG: boxes, outlines, pictures and text. All lengths are canvas
/// px.
class Canvas {
  public:
    /// @throws std::runtime_error if libvips cannot be started
    Canvas(int width, int height, Ink background);

    void fill(const Box& box, Ink colour);

    /// A picture CV_8UC3 (BGR) placed with its corner at `at`, in its own size, clipped to the canvas.
    void place(const cv::Mat& picture, Vec2 at);

    void outline(const Polygon& polygon, Ink colour, int thickness);

    void arrow(Vec2 from, Vec2 to, Ink colour, int thickness);

    /// One line of text with the middle of its capitals at `at.y`; what is not UTF-8 is shown as replacement
    /// characters.
    /// @param most_width  beyond it the middle of the text is left out
    /// @return            the width drawn
    int text(std::string_view line, Vec2 at, double size, Ink colour, TextWeight weight = TextWeight::normal,
             int most_width = 100'000);

    int text_width(std::string_view line, double size, TextWeight weight = TextWeight::normal) const;

    /// @throws std::runtime_error if the file cannot be written
    void write_png(const std::string& path) const;

    const cv::Mat& picture() const { return picture_; }

  private:
    cv::Mat picture_;  // CV_8UC3, BGR
};

}  // namespace vitrine::analyzer
