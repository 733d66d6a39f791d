#include "analyzer/saliency/saliency_network.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vitrine::analyzer {
namespace {

constexpr double min_range = 0.1;  // range of the output: below, the network sees nothing

/// The picture as the network was trained: each channel less ImageNet's mean, over ImageNet's deviation.
cv::Mat input_of(const cv::Mat& bgr, int side) {
    cv::Mat rgb;
    cv::resize(bgr, rgb, {side, side}, 0, 0, cv::INTER_AREA);
    cv::cvtColor(rgb, rgb, cv::COLOR_BGR2RGB);
    rgb.convertTo(rgb, CV_32FC3, 1.0 / 255);
    rgb -= cv::Scalar(0.485, 0.456, 0.406);
    cv::divide(rgb, cv::Scalar(0.229, 0.224, 0.225), rgb);
    return cv::dnn::blobFromImage(rgb);
}

/// Two equal sizes of a tensor, one after the other, as ONNX has them: each a field of two bytes' number.
std::string two_sizes(int side) {
    const std::string size{0x0a, 3, 8, static_cast<char>((side & 0x7f) | 0x80), static_cast<char>(side >> 7)};
    return size + size;
}

/// The output of U2-Net that joins the others is its first. OpenCV gives the last where none is named, and
/// that is the coarsest.
std::string first_output(const cv::dnn::Net& net) {
    return net.getUnconnectedOutLayersNames().at(0);
}

}  // namespace

std::string with_input_side(std::string model, int side) {
    const std::string full = two_sizes(full_side);
    for (std::size_t at = model.find(full); at != std::string::npos; at = model.find(full, at + full.size()))
        model.replace(at, full.size(), two_sizes(side));
    return model;
}

SaliencyNetwork::SaliencyNetwork(const std::string& file, int side) : file_(file), side_(side) {
    try {
        net_ = cv::dnn::readNetFromONNX(file);
        output_ = first_output(net_);
    } catch (const cv::Exception& e) {
        throw std::runtime_error("read saliency model '" + file + "': " + e.what());
    }
}

SaliencyNetwork::SaliencyNetwork(std::string file, std::span<const char> model, int side)
    : file_(std::move(file)), side_(side) {
    try {
        net_ = cv::dnn::readNetFromONNX(model.data(), model.size());
        output_ = first_output(net_);
    } catch (const cv::Exception& e) {
        throw std::runtime_error("read saliency model '" + file_ + "': " + e.what());
    }
}

SaliencyMap SaliencyNetwork::map(const cv::Mat& bgr) {
    cv::Mat output;
    try {
        net_.setInput(input_of(bgr, side_));
        output = net_.forward(output_);
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
