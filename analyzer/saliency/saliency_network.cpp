#include "analyzer/saliency/saliency_network.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace vitrine::analyzer {
namespace {

constexpr int input_step = 32;     // px
constexpr int min_input = 96;      // px
constexpr int max_shape = 2;       // times the side: a picture that is longer is drawn together
constexpr double min_range = 0.1;  // range of the output: below, the network sees nothing

/// The picture as the network was trained: each channel less ImageNet's mean, over ImageNet's deviation.
cv::Mat input_of(const cv::Mat& bgr, cv::Size size) {
    cv::Mat rgb;
    cv::resize(bgr, rgb, size, 0, 0, cv::INTER_AREA);
    cv::cvtColor(rgb, rgb, cv::COLOR_BGR2RGB);
    rgb.convertTo(rgb, CV_32FC3, 1.0 / 255);
    rgb -= cv::Scalar(0.485, 0.456, 0.406);
    cv::divide(rgb, cv::Scalar(0.229, 0.224, 0.225), rgb);
    return cv::dnn::blobFromImage(rgb);
}

/// The last two sizes of a tensor, as ONNX has them: each a field of two bytes' number.
std::string two_sizes(cv::Size size) {
    const auto field = [](int side) {
        return std::string{0x0a, 3, 8, static_cast<char>((side & 0x7f) | 0x80), static_cast<char>(side >> 7)};
    };
    return field(size.height) + field(size.width);
}

/// @return 0 where the model's input is no square of these sides
int declared_side(const std::string& model) {
    for (const int side : {full_side, coarse_side})
        if (model.find(two_sizes({side, side})) != std::string::npos) return side;
    return 0;
}

/// The same weights for pictures of another size.
std::string with_input(std::string model, int declared, cv::Size size) {
    const std::string square = two_sizes({declared, declared});
    for (std::size_t at = model.find(square); at != std::string::npos;
         at = model.find(square, at + square.size()))
        model.replace(at, square.size(), two_sizes(size));
    return model;
}

/// The output of U2-Net that joins the others is its first. OpenCV gives the last where none is named, and
/// that is the coarsest.
std::string first_output(const cv::dnn::Net& net) {
    return net.getUnconnectedOutLayersNames().at(0);
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

SaliencyNetwork::SaliencyNetwork(std::string file, std::string model, int side)
    : file_(std::move(file)), model_(std::move(model)), side_(side), declared_(declared_side(model_)) {}

void SaliencyNetwork::prepare(cv::Size input) {
    if (input == input_) return;
    try {
        const std::string model = is_scalable() ? with_input(model_, declared_, input) : model_;
        net_ = cv::dnn::readNetFromONNX(model.data(), model.size());
        output_ = first_output(net_);
        input_ = input;
    } catch (const cv::Exception& e) {
        throw std::runtime_error("read saliency model '" + file_ + "': " + e.what());
    }
}

SaliencyMap SaliencyNetwork::map(const cv::Mat& bgr) {
    const cv::Size input = is_scalable() ? look_size(bgr.size(), side_) : cv::Size(side_, side_);
    prepare(input);
    cv::Mat output;
    try {
        net_.setInput(input_of(bgr, input));
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
