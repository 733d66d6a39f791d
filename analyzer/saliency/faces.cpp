#include "analyzer/saliency/faces.hpp"

#include "analyzer/saliency/viola_jones.hpp"
#include "analyzer/saliency/yunet.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

// What a head has around its face box, as shares of the box.
constexpr double hair = 0.35;
constexpr double ear = 0.15;
constexpr double chin = 0.15;

/// exp(-(x - centre)^2 / (2 sigma^2)) at the centres of `count` pixels.
std::vector<float> bell(int count, double centre, double sigma) {
    std::vector<float> values(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const double z = (i + 0.5 - centre) / sigma;
        values[static_cast<std::size_t>(i)] = static_cast<float>(std::exp(-z * z / 2));
    }
    return values;
}

}  // namespace

std::unique_ptr<FaceDetector> face_detector(const std::string& model, const std::string& cascade) {
    if (!model.empty()) return std::make_unique<YuNet>(model);
    if (!cascade.empty()) return std::make_unique<ViolaJones>(cascade);
    return nullptr;
}

SaliencyMap face_saliency(std::span<const Face> faces, cv::Size size, double scale) {
    SaliencyMap map = SaliencyMap::zeros(size, CV_32FC1);
    for (const Face& face : faces) {
        const Vec2 centre = face.box.centre() * (1 / scale);
        const double half_width = std::max(0.5, face.box.width() / scale / 2);
        const double half_height = std::max(0.5, face.box.height() / scale / 2);
        const std::vector<float> across = bell(size.width, centre.x, half_width);
        const std::vector<float> down = bell(size.height, centre.y, half_height);
        for (int y = 0; y < size.height; ++y) {
            auto* row = map.ptr<float>(y);
            for (int x = 0; x < size.width; ++x) {
                row[x] =
                    std::max(row[x], across[static_cast<std::size_t>(x)] * down[static_cast<std::size_t>(y)]);
            }
        }
    }
    return map;
}

Box head_of(const Face& face) {
    const double w = face.box.width();
    const double h = face.box.height();
    return {face.box.min - Vec2{ear * w, hair * h}, face.box.max + Vec2{ear * w, chin * h}};
}

}  // namespace vitrine
