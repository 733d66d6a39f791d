#include "analyzer/saliency/saliency_network.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <stdexcept>

namespace vitrine::analyzer {
namespace {

constexpr int input_side = 320;
constexpr double min_range = 0.1;  // range of the output: below, the network sees nothing

/// The picture as the network was trained: each channel less ImageNet's mean, over ImageNet's deviation.
cv::Mat input_of(const cv::Mat& bgr) {
    cv::Mat rgb;
    cv::resize(bgr, rgb, {input_side, input_side}, 0, 0, cv::INTER_AREA);
    cv::cvtColor(rgb, rgb, cv::COLOR_BGR2RGB);
    rgb.convertTo(rgb, CV_32FC3, 1.0 / 255);
    rgb -= cv::Scalar(0.485, 0.456, 0.406);
    cv::divide(rgb, cv::Scalar(0.229, 0.224, 0.225), rgb);
    return cv::dnn::blobFromImage(rgb);
}

}  // namespace

SaliencyNetwork::SaliencyNetwork(const std::string& file) : file_(file) {
    try {
        net_ = cv::dnn::readNetFromONNX(file);
    } catch (const cv::Exception& e) {
        throw std::runtime_error("read saliency model '" + file + "': " + e.what());
    }
}

SaliencyMap SaliencyNetwork::map(const cv::Mat& bgr) {
    cv::Mat output;
    try {
        net_.setInput(input_of(bgr));
        output = net_.forward();
    } catch (const cv::Exception& e) {
        throw std::runtime_error("run saliency model '" + file_ + "': " + e.what());
    }
    if (output.dims != 4 || output.size[1] != 1 || output.type() != CV_32F)
        throw std::runtime_error("run saliency model '" + file_ + "': its first output is not one map");
    const cv::Mat plane(output.size[2], output.size[3], CV_32FC1, output.ptr<float>());
    double low = 0;
    double high = 0;
    cv::minMaxLoc(plane, &low, &high);
    return (plane - low) / std::max(min_range, high - low);
}

}  // namespace vitrine::analyzer
