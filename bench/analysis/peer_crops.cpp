#include "bench/analysis/peer_crops.hpp"

#include <opencv2/imgproc.hpp>
#include <vips/vips.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace vitrine::analyzer {
namespace {

cv::Size crop_size(cv::Size size, double share) {
    const double side = std::sqrt(std::clamp(share, 0.0, 1.0));
    return {std::clamp(cvRound(size.width * side), 1, size.width),
            std::clamp(cvRound(size.height * side), 1, size.height)};
}

Box box_at(double x, double y, cv::Size size) {
    return {{x, y}, {x + size.width, y + size.height}};
}

/// The weight of each place for a crop: smartcrop.js' detail, skin and saturation.
cv::Mat interest(const cv::Mat& bgr) {
    cv::Mat result(bgr.size(), CV_32FC1);
    cv::Mat grey;
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    cv::Mat edges;
    cv::Laplacian(grey, edges, CV_32F);
    for (int y = 0; y < bgr.rows; ++y) {
        for (int x = 0; x < bgr.cols; ++x) {
            const auto colour = bgr.at<cv::Vec3b>(y, x);
            const double b = colour[0] / 255.0;
            const double g = colour[1] / 255.0;
            const double r = colour[2] / 255.0;
            const double light = 0.0722 * b + 0.7152 * g + 0.5126 * r;
            const double length = std::sqrt(r * r + g * g + b * b) + 1e-9;
            const double off_skin =
                std::sqrt(std::pow(r / length - 0.78, 2) + std::pow(g / length - 0.57, 2) +
                          std::pow(b / length - 0.44, 2));
            const double high = std::max({r, g, b});
            const double low = std::min({r, g, b});
            const double middle = (high + low) / 2;
            const double range = high - low;
            const double saturated = range <= 0 ? 0 : range / (middle > 0.5 ? 2 - high - low : high + low);
            double value = 0.2 * std::max(0.0, static_cast<double>(edges.at<float>(y, x))) / 255;
            if (1 - off_skin > 0.8 && light >= 0.2) value += 1.8 * ((1 - off_skin) - 0.8) / 0.2;
            if (saturated > 0.4 && light >= 0.05 && light <= 0.9) value += 0.1 * (saturated - 0.4) / 0.6;
            result.at<float>(y, x) = static_cast<float>(value);
        }
    }
    return result;
}

/// The weight of a place, which is -1 to 1 from the crop's left to its right and top to bottom.
double importance(double x, double y) {
    if (std::abs(x) > 1 || std::abs(y) > 1) return -0.5;
    const auto near_third = [](double at) {
        const double off = (std::fmod(at - 1.0 / 3 + 1, 2.0) * 0.5 - 0.5) * 16;
        return std::max(1 - off * off, 0.0);
    };
    const double rim_x = std::max(std::abs(x) - 0.6, 0.0);
    const double rim_y = std::max(std::abs(y) - 0.6, 0.0);
    const double rim = (rim_x * rim_x + rim_y * rim_y) * -20;
    double inside = 1.41 - std::sqrt(x * x + y * y);
    inside += std::max(0.0, inside + rim + 0.5) * 1.2 * (near_third(std::abs(x)) + near_third(std::abs(y)));
    return inside + rim;
}

double score(const cv::Mat& interest, double left, double top, cv::Size crop, double step) {
    double sum = 0;
    for (int y = 0; y < interest.rows; ++y) {
        const double v = 2 * ((y + 0.5) * step - top) / crop.height - 1;
        const auto* row = interest.ptr<float>(y);
        for (int x = 0; x < interest.cols; ++x) {
            const double u = 2 * ((x + 0.5) * step - left) / crop.width - 1;
            sum += static_cast<double>(row[x]) * importance(u, v);
        }
    }
    return sum;
}

}  // namespace

Box centre_crop(cv::Size size, double share) {
    const cv::Size crop = crop_size(size, share);
    return box_at((size.width - crop.width) / 2.0, (size.height - crop.height) / 2.0, crop);
}

Box attention_crop(const cv::Mat& bgr, double share) {
    const cv::Size crop = crop_size(bgr.size(), share);
    cv::Mat rgb;
    cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
    VipsImage* image =
        vips_image_new_from_memory(rgb.data, rgb.total() * 3, rgb.cols, rgb.rows, 3, VIPS_FORMAT_UCHAR);
    VipsImage* srgb = nullptr;
    const bool is_copied = vips_copy(image, &srgb, "interpretation", VIPS_INTERPRETATION_sRGB, nullptr) == 0;
    g_object_unref(image);
    if (!is_copied) throw std::runtime_error(std::string("copy a picture: ") + vips_error_buffer());
    VipsImage* kept = nullptr;
    const bool is_cropped = vips_smartcrop(srgb, &kept, crop.width, crop.height, "interesting",
                                           VIPS_INTERESTING_ATTENTION, nullptr) == 0;
    g_object_unref(srgb);
    if (!is_cropped) throw std::runtime_error(std::string("crop a picture: ") + vips_error_buffer());
    const Box box = box_at(-vips_image_get_xoffset(kept), -vips_image_get_yoffset(kept), crop);
    g_object_unref(kept);
    return box;
}

Box smartcrop_crop(const cv::Mat& bgr, double share) {
    constexpr int side = 256;   // px, shorter side: where its search is done
    constexpr double step = 8;  // px, of its search and of the grid it scores on
    const double scale = std::min(1.0, static_cast<double>(side) / std::min(bgr.cols, bgr.rows));
    cv::Mat small;
    cv::resize(bgr, small, {}, scale, scale, cv::INTER_AREA);
    cv::Mat cells;
    cv::resize(interest(small), cells, {}, 1 / step, 1 / step, cv::INTER_AREA);
    const cv::Size crop = crop_size(small.size(), share);
    Vec2 best;
    double most = -std::numeric_limits<double>::infinity();
    for (double top = 0; top + crop.height <= small.rows; top += step) {
        for (double left = 0; left + crop.width <= small.cols; left += step) {
            const double now = score(cells, left, top, crop, step);
            if (now <= most) continue;
            most = now;
            best = {left, top};
        }
    }
    return box_at(best.x / scale, best.y / scale, crop_size(bgr.size(), share));
}

}  // namespace vitrine::analyzer
