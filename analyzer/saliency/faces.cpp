#include "analyzer/saliency/faces.hpp"

#include "analyzer/faces/viola_jones.hpp"
#include "analyzer/faces/yunet.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {
namespace {

// The head around a face box, as shares of the box.
constexpr double hair = 0.35;
constexpr double ear = 0.15;
constexpr double chin = 0.15;
// The body below a face: its centre below the face's, and its standard deviations, as shares of the face box.
constexpr double body_height = 2.0;
constexpr double body_sigma_x = 0.9;
constexpr double body_sigma_y = 1.2;
constexpr double body_strength = 0.8;
constexpr double prominence = 0.45;  // share of the tallest face

/// exp(-(x - centre)^2 / (2 sigma^2)) at the centres of `count` pixels.
std::vector<float> bell(int count, double centre, double sigma) {
    std::vector<float> values(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const double z = (i + 0.5 - centre) / sigma;
        values[static_cast<std::size_t>(i)] = static_cast<float>(std::exp(-z * z / 2));
    }
    return values;
}

/// Raises a map to the product of two bells where that is higher.
void raise(SaliencyMap& map, const std::vector<float>& across, const std::vector<float>& down,
           double strength) {
    for (int y = 0; y < map.rows; ++y) {
        auto* row = map.ptr<float>(y);
        const float share = static_cast<float>(strength) * down[static_cast<std::size_t>(y)];
        for (int x = 0; x < map.cols; ++x) {
            row[x] = std::max(row[x], across[static_cast<std::size_t>(x)] * share);
        }
    }
}

}  // namespace

std::unique_ptr<FaceDetector> face_detector(const std::string& model, const std::string& cascade) {
    if (!model.empty()) return std::make_unique<YuNet>(model);
    if (!cascade.empty()) return std::make_unique<ViolaJones>(cascade);
    return nullptr;
}

std::vector<Face> prominent(std::vector<Face> faces) {
    double tallest = 0;
    for (const Face& face : faces)
        tallest = std::max(tallest, face.box.height());
    std::erase_if(faces, [tallest](const Face& face) { return face.box.height() < prominence * tallest; });
    return faces;
}

SaliencyMap face_saliency(std::span<const Face> faces, cv::Size size, double scale, bool with_bodies) {
    SaliencyMap map = SaliencyMap::zeros(size, CV_32FC1);
    for (const Face& face : faces) {
        const Vec2 centre = face.box.centre() * (1 / scale);
        const double width = std::max(1.0, face.box.width() / scale);
        const double height = std::max(1.0, face.box.height() / scale);
        raise(map, bell(size.width, centre.x, width / 2), bell(size.height, centre.y, height / 2), 1);
        if (!with_bodies) continue;
        raise(map, bell(size.width, centre.x, body_sigma_x * width),
              bell(size.height, centre.y + body_height * height, body_sigma_y * height), body_strength);
    }
    return map;
}

Box head_of(const Face& face) {
    const double w = face.box.width();
    const double h = face.box.height();
    return {face.box.min - Vec2{ear * w, hair * h}, face.box.max + Vec2{ear * w, chin * h}};
}

}  // namespace vitrine::analyzer
