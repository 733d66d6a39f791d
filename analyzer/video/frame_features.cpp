#include "analyzer/video/frame_features.hpp"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdlib>

namespace vitrine {

namespace {

constexpr int counted_side = 160;  // px: about so many columns and rows are counted, more say nothing new

void count_colours(const cv::Mat& picture, FrameFeatures& features) {
    std::array<std::uint32_t, FrameFeatures::bins * FrameFeatures::bins * FrameFeatures::bins> counts{};
    const int step = std::max(1, std::max(picture.cols, picture.rows) / counted_side);
    std::uint32_t total = 0;
    for (int row = 0; row < picture.rows; row += step) {
        const auto* pixel = picture.ptr<std::uint8_t>(row);
        for (int x = 0; x < picture.cols; x += step, pixel += static_cast<std::ptrdiff_t>(3) * step)
            ++counts[static_cast<std::size_t>(pixel[0] >> 5 << 6 | pixel[1] >> 5 << 3 | pixel[2] >> 5)];
        total += static_cast<std::uint32_t>((picture.cols + step - 1) / step);
    }
    const double share = 65535.0 / total;
    for (std::size_t i = 0; i < counts.size(); ++i)
        features.histogram[i] = static_cast<std::uint16_t>(std::lround(counts[i] * share));
}

void sign(const cv::Mat& picture, FrameFeatures& features) {
    const cv::Size size(static_cast<int>(FrameFeatures::signature_width),
                        static_cast<int>(FrameFeatures::signature_height));
    cv::Mat small;
    cv::resize(picture, small, size, 0, 0, cv::INTER_AREA);
    cv::Mat grey(size, CV_8UC1, features.signature.data());
    cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(grey, mean, deviation);
    features.mean = mean[0];
    features.deviation = deviation[0];
}

}  // namespace

FrameFeatures features_of(const VideoFrame& frame) {
    FrameFeatures features;
    features.time = frame.time;
    count_colours(frame.picture, features);
    sign(frame.picture, features);
    return features;
}

double colour_difference(const FrameFeatures& a, const FrameFeatures& b) {
    int sum = 0;
    for (std::size_t i = 0; i < a.histogram.size(); ++i)
        sum += std::abs(int{a.histogram[i]} - int{b.histogram[i]});
    return sum / (2 * 65535.0);
}

double picture_difference(const FrameFeatures& a, const FrameFeatures& b) {
    int sum = 0;
    for (std::size_t i = 0; i < a.signature.size(); ++i)
        sum += std::abs(int{a.signature[i]} - int{b.signature[i]});
    return static_cast<double>(sum) / static_cast<double>(a.signature.size());
}

}  // namespace vitrine
