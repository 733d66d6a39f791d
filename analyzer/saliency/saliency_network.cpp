#include "analyzer/saliency/saliency_network.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::analyzer {
namespace {

constexpr int input_step = 32;     // px
constexpr int min_input = 96;      // px
constexpr int max_shape = 2;       // times the side: a picture that is longer is drawn together
constexpr double min_range = 0.1;  // range of the output: below, the network sees nothing

/// The picture in red, green and blue, as the network was trained.
cv::Mat input_of(const cv::Mat& bgr, cv::Size size) {
    cv::Mat rgb;
    cv::resize(bgr, rgb, size, 0, 0, cv::INTER_AREA);
    cv::cvtColor(rgb, rgb, cv::COLOR_BGR2RGB);
    return network_input(rgb);
}

}  // namespace

cv::Size look_size(cv::Size picture, int side) {
    const double scale = side / std::sqrt(static_cast<double>(picture.width) * picture.height);
    const auto stepped = [&](int length) {
        const auto steps = static_cast<int>(std::lround(length * scale / input_step));
        return std::clamp(steps * input_step, min_input, max_shape * side);
    };
    return {stepped(picture.width), stepped(picture.height)};
}

SaliencyNetwork::SaliencyNetwork(std::shared_ptr<Network> network, int side)
    : network_(std::move(network)), side_(side) {}

SaliencyMap SaliencyNetwork::map(const cv::Mat& bgr) {
    const cv::Size input = is_scalable() ? look_size(bgr.size(), side_) : cv::Size(side_, side_);
    const cv::Mat map = network_->map(input_of(bgr, input));
    double low = 0;
    double high = 0;
    cv::minMaxLoc(map, &low, &high);
    return (map - low) / std::max(min_range, high - low);
}

}  // namespace vitrine::analyzer
