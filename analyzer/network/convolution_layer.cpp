#include "analyzer/network/convolution_layer.hpp"

#include "analyzer/network/depthwise_convolution.hpp"
#include "analyzer/network/pointwise_convolution.hpp"
#include "analyzer/network/winograd_convolution.hpp"

#include <opencv2/dnn/all_layers.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace vitrine::analyzer {
namespace {

std::span<const float> values_of(const cv::Mat& tensor) {
    return {tensor.ptr<float>(), tensor.total()};
}

/// One value for each output, of a vector that has one, or one for all, or none.
float value_of(const cv::Mat& values, std::size_t output, float otherwise) {
    if (values.empty()) return otherwise;
    return values.ptr<float>()[values.total() == 1 ? 0 : output];
}

enum class Kind { pointwise, winograd, depthwise };

/// @return none: OpenCV computes it
std::optional<Kind> kind_of(const cv::dnn::LayerParams& params, const cv::dnn::BaseConvolutionLayer& layer) {
    const auto are_all = [](const std::vector<std::size_t>& sizes, int value) {
        return sizes == std::vector(2, static_cast<std::size_t>(value));
    };
    if (params.blobs.empty() || params.blobs[0].dims != 4 || params.blobs[0].type() != CV_32F) return {};
    const cv::Mat& weights = params.blobs[0];
    const int side = weights.size[2];
    const bool keeps_size = layer.padMode.empty() && are_all(layer.strides, 1) &&
                            are_all(layer.dilations, 1) && are_all(layer.pads_begin, side / 2) &&
                            are_all(layer.pads_end, side / 2);
    if (!keeps_size || side != weights.size[3]) return {};
    const int groups = params.get<int>("group", 1);
    if (groups == 1 && side == 1) return Kind::pointwise;
    if (groups == 1 && side == 3) return Kind::winograd;
    const bool is_depthwise = groups == weights.size[0] && weights.size[1] == 1;
    return is_depthwise && (side == 3 || side == 5) ? std::optional(Kind::depthwise) : std::nullopt;
}

std::unique_ptr<Convolution> make_kind(Kind kind, std::span<const float> weights,
                                       std::span<const float> biases) {
    switch (kind) {
    case Kind::pointwise:
        return std::make_unique<PointwiseConvolution>(weights, biases);
    case Kind::winograd:
        return std::make_unique<WinogradConvolution>(weights, biases);
    case Kind::depthwise:
        return std::make_unique<DepthwiseConvolution>(weights, biases);
    }
    return nullptr;
}

/// OpenCV's convolution tells the shapes; the values are computed here. Layers after it that scale, add, or
/// change each value for itself become part of it.
class FastLayer : public cv::dnn::Layer {
  public:
    FastLayer(const cv::dnn::LayerParams& params, Kind kind, cv::Ptr<cv::dnn::Layer> plain)
        : Layer(params), kind_(kind), plain_(std::move(plain)) {}

    bool getMemoryShapes(const std::vector<cv::dnn::MatShape>& inputs, int wanted,
                         std::vector<cv::dnn::MatShape>& outputs,
                         std::vector<cv::dnn::MatShape>& internals) const override {
        plain_->getMemoryShapes(inputs, wanted, outputs, internals);
        internals.clear();
        return false;
    }

    /// The input has another size: OpenCV tells the layers after this one anew.
    void finalize(cv::InputArrayOfArrays /*inputs*/, cv::OutputArrayOfArrays /*outputs*/) override {
        weights_ = blobs[0].clone();
        biases_ = blobs.size() > 1 ? blobs[1].clone() : cv::Mat::zeros(1, weights_.size[0], CV_32F);
        convolution_.reset();
    }

    bool setActivation(const cv::Ptr<cv::dnn::ActivationLayer>& next) override {
        if (next && has_activation_) return false;
        has_activation_ = static_cast<bool>(next);
        const auto rectifier = next.dynamicCast<cv::dnn::ReLULayer>();
        activation_ = rectifier && rectifier->negativeSlope == 0            ? Activation::rectified
                      : next && next.dynamicCast<cv::dnn::HardSwishLayer>() ? Activation::hard_swish
                                                                            : Activation::none;
        other_ = activation_ == Activation::none ? next : cv::Ptr<cv::dnn::ActivationLayer>();
        return has_activation_;
    }

    bool tryFuse(cv::Ptr<cv::dnn::Layer>& next) override {
        if (has_activation_) return false;
        cv::Mat scales;
        cv::Mat shifts;
        next->getScaleShift(scales, shifts);
        if (scales.empty() && shifts.empty()) return false;
        const auto outputs = static_cast<std::size_t>(weights_.size[0]);
        for (std::size_t i = 0; i < outputs; ++i) {
            const std::span weights(weights_.ptr<float>(static_cast<int>(i)), weights_.total() / outputs);
            const float scale = value_of(scales, i, 1);
            for (float& weight : weights)
                weight *= scale;
            float& bias = biases_.ptr<float>()[i];
            bias = bias * scale + value_of(shifts, i, 0);
        }
        return true;
    }

    void forward(cv::InputArrayOfArrays inputs, cv::OutputArrayOfArrays outputs,
                 cv::OutputArrayOfArrays /*internals*/) override {
        if (!convolution_) {
            convolution_ = make_kind(kind_, values_of(weights_), values_of(biases_));
            weights_.release();
            biases_.release();
        }
        std::vector<cv::Mat> from;
        std::vector<cv::Mat> to;
        inputs.getMatVector(from);
        outputs.getMatVector(to);
        const PlaneSize size{from[0].size[2], from[0].size[3]};
        for (int i = 0; i < from[0].size[0]; ++i) {
            auto* result = to[0].ptr<float>(i);
            convolution_->run(from[0].ptr<float>(i), size, activation_, result);
            const int pixels = size.height * size.width;
            if (other_)
                other_->forwardSlice(result, result, pixels, static_cast<std::size_t>(pixels), 0,
                                     to[0].size[1]);
        }
    }

  private:
    Kind kind_;
    cv::Ptr<cv::dnn::Layer> plain_;
    cv::Mat weights_;  // with the layers that became part; empty once the convolution is made
    cv::Mat biases_;   // one for each output; the same
    bool has_activation_ = false;
    Activation activation_ = Activation::none;
    cv::Ptr<cv::dnn::ActivationLayer> other_;   // activation that only OpenCV knows; null: none
    std::unique_ptr<Convolution> convolution_;  // from the first run on
};

cv::Ptr<cv::dnn::Layer> make_convolution(cv::dnn::LayerParams& params) {
    const cv::Ptr<cv::dnn::BaseConvolutionLayer> plain = cv::dnn::ConvolutionLayer::create(params);
    const std::optional<Kind> kind = kind_of(params, *plain);
    if (!kind) return plain;
    return cv::makePtr<FastLayer>(params, *kind, plain);
}

}  // namespace

void use_fast_convolutions() {
    static const bool is_registered = [] {
        cv::dnn::LayerFactory::registerLayer("Convolution", make_convolution);
        return true;
    }();
    static_cast<void>(is_registered);
}

}  // namespace vitrine::analyzer
