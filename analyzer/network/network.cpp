#include "analyzer/network/network.hpp"

#include "analyzer/network/convolution_layer.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vitrine::analyzer {
namespace {

constexpr std::size_t max_nets = 2;

/// The last two sizes of a tensor, as ONNX has them: each a field of two bytes' number.
std::string two_sizes(cv::Size size) {
    const auto field = [](int side) {
        return std::string{0x0a, 3, 8, static_cast<char>((side & 0x7f) | 0x80), static_cast<char>(side >> 7)};
    };
    return field(size.height) + field(size.width);
}

/// @return 0 where the model's input is no square of these sides
int declared_side(const std::string& model) {
    for (const int side : {320, 160})
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

}  // namespace

cv::Mat network_input(const cv::Mat& picture) {
    cv::Mat input;
    picture.convertTo(input, CV_32FC3, 1.0 / 255);
    input -= cv::Scalar(0.485, 0.456, 0.406);
    cv::divide(input, cv::Scalar(0.229, 0.224, 0.225), input);
    return cv::dnn::blobFromImage(input);
}

Network::Network(std::string name, std::string model)
    : name_(std::move(name)), model_(std::move(model)), declared_(declared_side(model_)) {
    use_fast_convolutions();
    if (!declares_square()) nets_.push_back(prepared({}));
}

// The output of U2-Net that joins the others is its first. OpenCV gives the last where none is named, and
// that is the coarsest.
Network::SizedNet Network::prepared(cv::Size size) const {
    try {
        const std::string sized = declares_square() ? with_input(model_, declared_, size) : std::string();
        const std::string& model = declares_square() ? sized : model_;
        SizedNet made{
            .net = cv::dnn::readNetFromONNX(model.data(), model.size()), .output = {}, .size = size};
        made.output = made.net.getUnconnectedOutLayersNames().at(0);
        return made;
    } catch (const cv::Exception& e) {
        throw std::runtime_error("read " + name_ + ": " + e.what());
    }
}

Network::SizedNet& Network::net_for(cv::Size size) {
    const auto known = std::ranges::find_if(
        nets_, [&](const SizedNet& net) { return net.size == size || net.size.empty(); });
    if (known != nets_.end()) {
        known->size = size;
        return *known;
    }
    if (nets_.size() >= max_nets) nets_.erase(nets_.begin());
    nets_.push_back(prepared(size));
    return nets_.back();
}

cv::Mat Network::map(const cv::Mat& input) {
    SizedNet& net = net_for({input.size[3], input.size[2]});
    cv::Mat output;
    try {
        net.net.setInput(input);
        output = net.net.forward(net.output);
    } catch (const cv::Exception& e) {
        throw std::runtime_error("run " + name_ + ": " + e.what());
    }
    if (output.dims != 4 || output.size[1] != 1 || output.type() != CV_32F)
        throw std::runtime_error("run " + name_ + ": its first output is not one map");
    return cv::Mat(output.size[2], output.size[3], CV_32FC1, output.ptr<float>()).clone();
}

}  // namespace vitrine::analyzer
