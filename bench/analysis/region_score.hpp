#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include <filesystem>
#include <vector>

namespace vitrine::analyzer {

/// A picture as BGR, its longest side at most `side` px; empty, and said why, where it cannot be read.
cv::Mat picture(const std::filesystem::path& path, int side);

/// The boxes under a key of a label, fractions of the picture.
std::vector<Box> boxes(const nlohmann::json& entry, const char* key);

/// 255 inside. The boxes are fractions of the size, the polygon px.
cv::Mat filled(cv::Size size, const std::vector<Box>& fractions);
cv::Mat filled(cv::Size size, const Polygon& polygon);

/// The part of a subject that a region holds; sums of several pictures where count > 1.
struct RegionScore {
    double iou = 0;
    double coverage = 0;  // share of the subject
    double area = 0;      // share of the picture
    int whole_faces = 0;
    int faces = 0;
    int count = 0;

    void add(const RegionScore& s);
};

RegionScore region_score(const Polygon& region, cv::Size size, const cv::Mat& subject, const cv::Mat& ignored,
                         const std::vector<Box>& faces);

}  // namespace vitrine::analyzer
