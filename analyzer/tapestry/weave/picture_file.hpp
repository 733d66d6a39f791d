#pragma once

#include <opencv2/core.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace vitrine::analyzer {

/// Writes a picture CV_8UC3 (BGR) as a whole or not at all; both throw std::runtime_error or
/// std::system_error, which name the file.
void write_jpeg(const std::filesystem::path& file, const cv::Mat& bgr);
void write_png(const std::filesystem::path& file, const cv::Mat& bgr);

/// Reads a picture that write_png() has written. @throws std::runtime_error, std::system_error, which name
/// the file
cv::Mat read_png(const std::filesystem::path& file);

/// Codes a picture in memory. @param quality  1 to 100; colours are not sampled down
/// @throws std::runtime_error
std::string to_jpeg(const cv::Mat& bgr, int quality);
cv::Mat from_jpeg(std::string_view jpeg);

}  // namespace vitrine::analyzer
