#pragma once

#include <opencv2/core.hpp>

#include <filesystem>

namespace vitrine {

/// Writes a picture CV_8UC3 (BGR) as a whole or not at all; both throw std::runtime_error or
/// std::system_error, which name the file.
void write_jpeg(const std::filesystem::path& file, const cv::Mat& bgr);
void write_png(const std::filesystem::path& file, const cv::Mat& bgr);

}  // namespace vitrine
