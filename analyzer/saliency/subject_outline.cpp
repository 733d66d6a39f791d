#include "analyzer/saliency/subject_outline.hpp"

#include "base/geometry/convex_hull.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace vitrine::analyzer {
namespace {

constexpr double strict = 0.5;  // values from which a pixel is the subject's
constexpr double fair = 0.35;   // of two looks most of one is enough
constexpr double generous = 0.1;
constexpr double speck = 0.05;      // share of the mass of the heaviest part
constexpr double growth_doubt = 2;  // doubt for each share of the picture's side that the outline grows

/// The labels of the pixels from a value on, one for each connected part; 0: none or a speck.
cv::Mat heavy_parts(const SaliencyMap& map, double threshold) {
    cv::Mat labels;
    const int count = cv::connectedComponents(map >= threshold, labels, 8, CV_32S);
    std::vector<double> mass(static_cast<std::size_t>(count));
    for (int y = 0; y < map.rows; ++y)
        for (int x = 0; x < map.cols; ++x)
            mass[static_cast<std::size_t>(labels.at<int>(y, x))] += static_cast<double>(map.at<float>(y, x));
    mass[0] = 0;
    const double least = speck * *std::max_element(mass.begin(), mass.end());
    for (int y = 0; y < map.rows; ++y) {
        for (int x = 0; x < map.cols; ++x) {
            int& label = labels.at<int>(y, x);
            if (mass[static_cast<std::size_t>(label)] < least) label = 0;
        }
    }
    return labels;
}

/// The convex hull of the pixels that are not 0.
Polygon hull_of(const cv::Mat& labels) {
    std::vector<Vec2> corners;
    for (int y = 0; y < labels.rows; ++y) {
        for (int x = 0; x < labels.cols; ++x) {
            if (labels.at<int>(y, x) == 0) continue;
            for (const Vec2 corner : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}})
                corners.push_back(Vec2{static_cast<double>(x), static_cast<double>(y)} + corner);
        }
    }
    const Polygon hull = convex_hull(corners);
    return hull.size() < 3 ? Polygon{} : hull;
}

/// The parts from a value on, and each part of fainter ones that holds none of them: one more thing. What is
/// faint about a part is its surroundings.
cv::Mat things(const cv::Mat& parts, const cv::Mat& faint_parts) {
    std::set<int> taken{0};
    for (int y = 0; y < parts.rows; ++y)
        for (int x = 0; x < parts.cols; ++x)
            if (parts.at<int>(y, x) != 0) taken.insert(faint_parts.at<int>(y, x));
    cv::Mat result = parts.clone();
    for (int y = 0; y < parts.rows; ++y) {
        for (int x = 0; x < parts.cols; ++x) {
            const int label = faint_parts.at<int>(y, x);
            if (!taken.contains(label)) result.at<int>(y, x) = label;
        }
    }
    return result;
}

double undecided_share(const SaliencyMap& map) {
    const double mass = cv::sum(map)[0];
    return mass > 0 ? 1 - map.dot(map) / mass : 1;
}

}  // namespace

SubjectOutline subject_outline(const SaliencyMap& map) {
    const cv::Mat parts = heavy_parts(map, fair);
    if (cv::countNonZero(parts) == 0) return {};
    const cv::Mat possible = heavy_parts(map, generous);
    SubjectOutline outline{.sure = hull_of(things(parts, possible)), .possible = hull_of(possible)};
    const auto side = [&](const Polygon& hull) {
        return std::sqrt(area(hull) / static_cast<double>(map.total()));
    };
    const double growth = side(outline.possible) - side(hull_of(heavy_parts(map, strict)));
    const double doubt = std::min(undecided_share(map), growth_doubt * growth);
    outline.certainty = std::clamp(1 - doubt, 0.0, 1.0);
    return outline;
}

}  // namespace vitrine::analyzer
