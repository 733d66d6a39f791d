#include "analyzer/explain/canvas.hpp"

#include "base/media/still_picture.hpp"

#include <fmt/format.h>
#include <glib.h>
#include <opencv2/imgproc.hpp>
#include <vips/vips.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

namespace vitrine::analyzer {
namespace {

constexpr int sub_pixel_bits = 4;
constexpr int text_dpi = 72;         // so that a point is a pixel
constexpr double cap_height = 0.73;  // share of the size, DejaVu Sans
constexpr const char* typeface = "DejaVu Sans";

struct Unref {
    void operator()(void* object) const { g_object_unref(object); }
};

using ImagePtr = std::unique_ptr<VipsImage, Unref>;
using TargetPtr = std::unique_ptr<VipsTarget, Unref>;

struct GFree {
    void operator()(void* memory) const { g_free(memory); }
};

cv::Scalar bgr(Ink colour) {
    return {static_cast<double>(colour & 0xFFU), static_cast<double>((colour >> 8U) & 0xFFU),
            static_cast<double>((colour >> 16U) & 0xFFU)};
}

std::string valid_text(std::string_view line) {
    const std::unique_ptr<char, GFree> valid(
        g_utf8_make_valid(line.data(), static_cast<gssize>(line.size())));
    return valid.get();
}

/// The coverage of a line of text, CV_8UC1, as high as the line; empty where there is nothing to draw.
cv::Mat text_mask(const std::string& line, double size, TextWeight weight) {
    if (line.find_first_not_of(' ') == std::string::npos) return {};
    const std::unique_ptr<char, GFree> markup(g_markup_escape_text(line.c_str(), -1));
    const std::string font =
        fmt::format("{}{} {:g}", typeface, weight == TextWeight::bold ? " Bold" : "", size);
    VipsImage* made = nullptr;
    const int failed = vips_text(&made, markup.get(), "font", font.c_str(), "dpi", text_dpi, nullptr);
    if (failed != 0) throw std::runtime_error(fmt::format("draw text '{}': {}", line, vips_error_buffer()));
    const ImagePtr image(made);
    std::size_t bytes = 0;
    const std::unique_ptr<void, GFree> data(vips_image_write_to_memory(image.get(), &bytes));
    if (data == nullptr)
        throw std::runtime_error(fmt::format("draw text '{}': {}", line, vips_error_buffer()));
    const cv::Mat mask(vips_image_get_height(image.get()), vips_image_get_width(image.get()), CV_8UC1,
                       data.get());
    return mask.clone();
}

/// The depth of a line's ink below its baseline, px: vips_text crops to the ink.
double descent(const std::string& line, double size) {
    if (line.find('_') != std::string::npos) return 0.28 * size;
    if (line.find_first_of("gjpqy()[]") != std::string::npos) return 0.22 * size;
    return line.find_first_of(",;") != std::string::npos ? 0.14 * size : 0;
}

}  // namespace

Canvas::Canvas(int width, int height, Ink background) : picture_(height, width, CV_8UC3, bgr(background)) {
    init_vips();
}

void Canvas::fill(const Box& box, Ink colour) {
    const cv::Rect r(cv::Point2d(box.min.x, box.min.y), cv::Point2d(box.max.x, box.max.y));
    picture_(r & cv::Rect({}, picture_.size())).setTo(bgr(colour));
}

void Canvas::place(const cv::Mat& picture, Vec2 at) {
    const cv::Rect all(static_cast<int>(at.x), static_cast<int>(at.y), picture.cols, picture.rows);
    const cv::Rect seen = all & cv::Rect({}, picture_.size());
    if (!seen.empty()) picture(seen - all.tl()).copyTo(picture_(seen));
}

void Canvas::outline(const Polygon& polygon, Ink colour, int thickness) {
    std::vector<cv::Point> points;
    for (const Vec2 p : polygon) {
        points.emplace_back(static_cast<int>(std::lround(p.x * (1 << sub_pixel_bits))),
                            static_cast<int>(std::lround(p.y * (1 << sub_pixel_bits))));
    }
    cv::polylines(picture_, points, true, bgr(colour), thickness, cv::LINE_AA, sub_pixel_bits);
}

void Canvas::arrow(Vec2 from, Vec2 to, Ink colour, int thickness) {
    const auto point = [](Vec2 p) { return cv::Point(cv::Point2d(p.x, p.y) * (1 << sub_pixel_bits)); };
    const double head = std::clamp(8 / length(to - from), 0.0, 0.5);
    cv::arrowedLine(picture_, point(from), point(to), bgr(colour), thickness, cv::LINE_AA, sub_pixel_bits,
                    head);
}

int Canvas::text_width(std::string_view line, double size) const {
    return text_mask(valid_text(line), size, TextWeight::normal).cols;
}

int Canvas::text(std::string_view line, Vec2 at, const TextStyle& style, int max_width) {
    std::string shown = valid_text(line);
    cv::Mat mask = text_mask(shown, style.size, style.weight);
    for (glong left = g_utf8_strlen(shown.c_str(), -1) - 2; mask.cols > max_width && left > 4; left -= 2) {
        const std::string full = valid_text(line);
        const std::unique_ptr<char, GFree> head(g_utf8_substring(full.c_str(), 0, left / 2));
        const std::unique_ptr<char, GFree> tail(
            g_utf8_substring(full.c_str(), g_utf8_strlen(full.c_str(), -1) - left / 2, -1));
        shown = fmt::format("{}…{}", head.get(), tail.get());
        mask = text_mask(shown, style.size, style.weight);
    }
    if (mask.empty()) return 0;
    const double baseline = at.y + cap_height / 2 * style.size;
    const int top = static_cast<int>(std::lround(baseline + descent(shown, style.size))) - mask.rows;
    const cv::Rect all(static_cast<int>(at.x), top, mask.cols, mask.rows);
    const cv::Rect seen = all & cv::Rect({}, picture_.size());
    if (seen.empty()) return mask.cols;
    cv::Mat target = picture_(seen);
    const cv::Scalar ink = bgr(style.colour);
    const cv::Mat coverage = mask(seen - all.tl());
    for (int y = 0; y < target.rows; ++y) {
        for (int x = 0; x < target.cols; ++x) {
            auto& pixel = target.at<cv::Vec3b>(y, x);
            const double share = coverage.at<unsigned char>(y, x) / 255.0;
            for (int c = 0; c < 3; ++c) {
                pixel[c] = cv::saturate_cast<unsigned char>(pixel[c] + (ink[c] - pixel[c]) * share);
            }
        }
    }
    return mask.cols;
}

void Canvas::write_png(int file) const {
    cv::Mat rgb;
    cv::cvtColor(picture_, rgb, cv::COLOR_BGR2RGB);
    const ImagePtr image(
        vips_image_new_from_memory(rgb.data, rgb.total() * 3, rgb.cols, rgb.rows, 3, VIPS_FORMAT_UCHAR));
    const TargetPtr target(vips_target_new_to_descriptor(file));
    if (image != nullptr) image->Type = VIPS_INTERPRETATION_sRGB;
    if (image == nullptr || target == nullptr ||
        vips_pngsave_target(image.get(), target.get(), "compression", 6, nullptr) != 0)
        throw std::runtime_error(fmt::format("write the picture: {}", vips_error_buffer()));
}

}  // namespace vitrine::analyzer
