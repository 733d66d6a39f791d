#include "analyzer/faces/yunet.hpp"

#include "analyzer/network/convolution_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace vitrine::analyzer {
namespace {

constexpr std::array<int, 3> strides{8, 16, 32};  // px between the anchors of the three output levels
constexpr int input_multiple = 32;
constexpr int min_input = 64;  // px: where the coarsest level has one row OpenCV 4.6 finds faces at random
constexpr float min_score = 0.6F;
constexpr float max_overlap = 0.3F;  // intersection over union of two boxes of one face

struct FoundBoxes {
    std::vector<cv::Rect2d> boxes;
    std::vector<float> scores;
};

/// One output level. Each anchor (column, row) has class and object scores, and a box as the offset of its
/// centre in strides and the logarithm of its size in strides.
struct Level {
    cv::Mat classes, objects, boxes;
    int stride = 0;   // px between anchors
    int columns = 0;  // anchors a row
};

/// Adds the boxes of one level.
void decode(const Level& level, FoundBoxes& into) {
    const auto* cls = level.classes.ptr<float>();
    const auto* obj = level.objects.ptr<float>();
    const auto* box = level.boxes.ptr<float>();
    const int stride = level.stride;
    const int columns = level.columns;
    const auto count = static_cast<int>(level.classes.total());
    for (int i = 0; i < count; ++i) {
        const float score = std::sqrt(std::max(0.F, cls[i]) * std::max(0.F, obj[i]));
        if (!(score >= min_score)) continue;
        const auto value = [box, i](int k) { return static_cast<double>(box[4 * i + k]); };
        const double width = std::exp(value(2)) * stride;
        const double height = std::exp(value(3)) * stride;
        const double x = (i % columns + value(0)) * stride - width / 2;
        const int row = i / columns;
        const double y = (row + value(1)) * stride - height / 2;
        into.boxes.emplace_back(x, y, width, height);
        into.scores.push_back(std::min(1.F, score));
    }
}

int rounded_up(int value) {
    return std::max(min_input, (value + input_multiple - 1) / input_multiple * input_multiple);
}

}  // namespace

YuNet::YuNet(const std::string& model) {
    use_fast_convolutions();
    try {
        net_ = cv::dnn::readNetFromONNX(model);
    } catch (const cv::Exception& e) {
        throw std::runtime_error("read face model '" + model + "': " + e.what());
    }
}

std::vector<Face> YuNet::detect(const cv::Mat& bgr) {
    cv::Mat padded;
    cv::copyMakeBorder(bgr, padded, 0, rounded_up(bgr.rows) - bgr.rows, 0, rounded_up(bgr.cols) - bgr.cols,
                       cv::BORDER_CONSTANT);
    net_.setInput(cv::dnn::blobFromImage(padded));
    std::vector<cv::String> names;
    for (const char* kind : {"cls_", "obj_", "bbox_"}) {
        for (const int stride : strides)
            names.push_back(kind + std::to_string(stride));
    }
    std::vector<cv::Mat> outputs;
    net_.forward(outputs, names);
    FoundBoxes found;
    for (std::size_t level = 0; level < strides.size(); ++level) {
        decode({outputs[level], outputs[level + 3], outputs[level + 6], strides[level],
                padded.cols / strides[level]},
               found);
    }
    std::vector<int> kept;
    cv::dnn::NMSBoxes(found.boxes, found.scores, min_score, max_overlap, kept);
    std::vector<Face> faces;
    const Box picture{{0, 0}, {static_cast<double>(bgr.cols), static_cast<double>(bgr.rows)}};
    for (const int i : kept) {
        const cv::Rect2d& r = found.boxes[static_cast<std::size_t>(i)];
        const Box box = intersection({{r.x, r.y}, {r.x + r.width, r.y + r.height}}, picture);
        if (box.is_empty()) continue;
        faces.push_back(
            {.box = box, .score = static_cast<double>(found.scores[static_cast<std::size_t>(i)])});
    }
    return faces;
}

}  // namespace vitrine::analyzer
