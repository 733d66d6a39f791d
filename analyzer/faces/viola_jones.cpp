#include "analyzer/faces/viola_jones.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <stdexcept>

namespace vitrine::analyzer {
namespace {

constexpr double searched_side = 400;  // px, longest side: larger finds no more of 23 marked faces
constexpr double pyramid_step = 1.15;
constexpr int min_neighbours = 3;    // overlapping hits that make a face
constexpr double min_face = 0.08;    // share of the picture's shorter side
constexpr int min_face_pixels = 20;  // the cascade was trained at this size
constexpr double sideways = 0.1;     // share of the box: it lies so far off on faces turned aside

}  // namespace

ViolaJones::ViolaJones(const std::string& cascade) {
    if (!cascade_.load(cascade))
        throw std::runtime_error("read face cascade '" + cascade + "': not a cascade");
}

std::vector<Face> ViolaJones::detect(const cv::Mat& bgr) {
    cv::Mat grey;
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    const double scale = std::min(1.0, searched_side / std::max(grey.cols, grey.rows));
    if (scale < 1) cv::resize(grey, grey, {}, scale, scale, cv::INTER_AREA);
    cv::equalizeHist(grey, grey);
    const int min_face_side =
        std::max(min_face_pixels, static_cast<int>(min_face * std::min(grey.cols, grey.rows)));
    std::vector<cv::Rect> found;
    cascade_.detectMultiScale(grey, found, pyramid_step, min_neighbours, 0, {min_face_side, min_face_side});
    std::vector<Face> faces;
    const Box picture{{0, 0}, {static_cast<double>(bgr.cols), static_cast<double>(bgr.rows)}};
    for (const cv::Rect& r : found) {
        const Vec2 corner{r.x / scale, r.y / scale};
        const Vec2 size{r.width / scale, r.height / scale};
        const Vec2 slack{sideways * size.x, 0};
        faces.push_back({.box = intersection({corner - slack, corner + size + slack}, picture), .score = 1});
    }
    return faces;
}

}  // namespace vitrine::analyzer
