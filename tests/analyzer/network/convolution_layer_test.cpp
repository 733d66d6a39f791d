#include "analyzer/network/convolution_layer.hpp"

#include <doctest/doctest.h>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

#include <string>
#include <vector>

namespace vitrine::analyzer {
namespace {

/// A network of the tree, and a size that it takes.
struct Model {
    const char* file = nullptr;
    cv::Size size;
};

std::vector<cv::Mat> outputs_of(cv::dnn::Net& net, const cv::Mat& input) {
    net.setInput(input);
    std::vector<cv::Mat> outputs;
    net.forward(outputs, net.getUnconnectedOutLayersNames());
    for (cv::Mat& output : outputs)
        output = output.clone();
    return outputs;
}

cv::Mat drawn_input(cv::Size size) {
    cv::Mat picture(size, CV_32FC3, cv::Scalar(0.4, 0.2, -0.3));
    cv::RNG random(11);
    random.fill(picture, cv::RNG::NORMAL, 0, 0.4);
    cv::GaussianBlur(picture, picture, {0, 0}, 2);
    cv::putText(picture, "MENU 7,80", {size.width / 16, size.height / 2}, cv::FONT_HERSHEY_SIMPLEX,
                size.width / 180.0, cv::Scalar(2, 2, 2), 3);
    cv::circle(picture, {size.width * 2 / 3, size.height * 3 / 4}, size.height / 6, cv::Scalar(2, -1, 1), -1);
    return cv::dnn::blobFromImage(picture);
}

/// A convolution whose result is scaled, shifted and cut off at 0.
cv::dnn::Net scaled_net(int side) {
    cv::RNG random(3);
    cv::dnn::LayerParams convolution;
    convolution.set("kernel_size", side);
    convolution.set("num_output", 4);
    convolution.set("pad", side / 2);
    convolution.set("bias_term", true);
    convolution.blobs = {cv::Mat({4, 3, side, side}, CV_32F), cv::Mat(1, 4, CV_32F)};
    cv::dnn::LayerParams scale;
    scale.set("bias_term", true);
    scale.blobs = {cv::Mat(1, 4, CV_32F), cv::Mat(1, 4, CV_32F)};
    for (cv::dnn::LayerParams* params : {&convolution, &scale})
        for (cv::Mat& blob : params->blobs)
            random.fill(blob, cv::RNG::UNIFORM, -1, 1);
    cv::dnn::LayerParams cut;
    cv::dnn::Net net;
    net.addLayerToPrev("convolution", "Convolution", convolution);
    net.addLayerToPrev("scale", "Scale", scale);
    net.addLayerToPrev("cut", "ReLU", cut);
    return net;
}

}  // namespace

TEST_CASE("the networks of the tree give the same with fast convolutions as with OpenCV's") {
    const std::vector<Model> models{{"student.onnx", {160, 160}},
                                    {"u2netp.onnx", {320, 320}},
                                    {"text_detection.onnx", {320, 96}},
                                    {"face_detection_yunet.onnx", {160, 96}}};
    std::vector<cv::dnn::Net> plain;  // read before: how a layer computes is chosen as it is read
    for (const Model& model : models)
        plain.push_back(cv::dnn::readNetFromONNX(std::string(VITRINE_MODELS "/") + model.file));
    std::vector<cv::dnn::Net> plain_scaled{scaled_net(1), scaled_net(3)};
    for (cv::dnn::Net& net : plain_scaled)
        (void)outputs_of(net, drawn_input({40, 24}));  // layers are made now
    use_fast_convolutions();
    use_fast_convolutions();  // a second time changes nothing
    for (std::size_t i = 0; i < models.size(); ++i) {
        CAPTURE(models[i].file);
        cv::dnn::Net fast = cv::dnn::readNetFromONNX(std::string(VITRINE_MODELS "/") + models[i].file);
        const cv::Mat input = drawn_input(models[i].size);
        const std::vector<cv::Mat> wanted = outputs_of(plain[i], input);
        const std::vector<cv::Mat> found = outputs_of(fast, input);
        REQUIRE(found.size() == wanted.size());
        double most = 0;
        for (std::size_t k = 0; k < found.size(); ++k) {
            most = std::max(most, cv::norm(wanted[k], cv::NORM_INF));
            CHECK(cv::norm(found[k], wanted[k], cv::NORM_INF) <
                  1e-3 * std::max(1.0, cv::norm(wanted[k], cv::NORM_INF)));
        }
        CHECK(most > 0.1);  // something is seen
    }

    for (const int side : {1, 3}) {
        CAPTURE(side);
        cv::dnn::Net fast = scaled_net(side);
        for (const cv::Size size : {cv::Size(40, 24), cv::Size(24, 40), cv::Size(40, 24)}) {
            const cv::Mat input = drawn_input(size);
            const cv::Mat wanted = outputs_of(plain_scaled[side == 1 ? 0 : 1], input).front();
            CHECK(cv::norm(outputs_of(fast, input).front(), wanted, cv::NORM_INF) < 1e-4);
            CHECK(cv::norm(wanted, cv::NORM_INF) > 0.1);
        }
    }
}

}  // namespace vitrine::analyzer
