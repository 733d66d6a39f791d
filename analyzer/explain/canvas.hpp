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

struct TextStyle {
    double size = 12;  // px
    Ink colour = 0;
    TextWeight weight = TextWeight::normal;
};

/// A picture to draw on and to write as PNG: boxes, outlines, pictures and text. All lengths are canvas px.
class Canvas {
  public:
    /// @throws std::runtime_error if libvips cannot be started
    Canvas(int width, int height, Ink background);

    void fill(const Box& box, Ink colour);

    /// Draws a picture CV_8UC3 (BGR) with its corner at `at`, in its own size, clipped to the canvas.
    void place(const cv::Mat& picture, Vec2 at);

    void outline(const Polygon& polygon, Ink colour, int thickness);

    void arrow(Vec2 from, Vec2 to, Ink colour, int thickness);

    /// Draws one line with the middle of its capitals at `at.y`. Bytes that are not UTF-8 become replacement
    /// characters.
    /// @param max_width  a wider line is shown without the middle of its text
    /// @return           the width drawn
    int text(std::string_view line, Vec2 at, const TextStyle& style, int max_width = 100'000);

    int text_width(std::string_view line, double size) const;

    /// Writes into an open file. @throws std::runtime_error if it cannot be written
    void write_png(int file) const;

    const cv::Mat& picture() const { return picture_; }

  private:
    cv::Mat picture_;  // CV_8UC3, BGR
};

}  // namespace vitrine::analyzer
