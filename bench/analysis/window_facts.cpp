// Writes what the weights of the plain method's windows are fitted to (fit_windows.py):
//   window_facts PICTURES OUTPUT [STEP]
// For every STEP-th picture of the folder, in the order of names, in which u2netp is sure of the subject:
// left, top, right and bottom of the subject's box, as shares of the sides, and then the facts of all
// windows, as 32-bit floats.

#include "analyzer/one_file/subject_network.hpp"
#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/faces.hpp"
#include "analyzer/saliency/sample.hpp"
#include "analyzer/saliency/subject_outline.hpp"
#include "analyzer/saliency/subject_windows.hpp"
#include "base/geometry/polygon.hpp"
#include "bench/analysis/region_score.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

constexpr int photo_side = 640;  // px, as photographs are analysed

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// The windows as the analyzer makes them of a photo.
std::vector<SubjectWindow> windows_of(const cv::Mat& photo, FaceDetector& detector) {
    const AnalysisSettings settings;
    const double scale = static_cast<double>(settings.frame_size) / std::max(photo.cols, photo.rows);
    cv::Mat small = photo;
    if (scale < 1) cv::resize(photo, small, scaled_size(photo.size(), scale), 0, 0, cv::INTER_AREA);
    std::vector<Face> faces = find_faces(detector, photo, settings.only_prominent_faces);
    const double own = static_cast<double>(small.cols) / map_size(photo.size()).width;
    for (Face& face : faces)
        face.box = {face.box.min * own, face.box.max * own};
    return subject_windows(small, faces);
}

void write(std::ofstream& file, std::span<const float> values) {
    const auto bytes = std::as_bytes(values);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void write_facts(const std::filesystem::path& folder, std::ofstream& output, std::size_t step) {
    const auto detector =
        face_detector(VITRINE_MODELS "/face_detection_yunet.onnx", AnalysisSettings{}.face_cascade);
    const auto network =
        photo_network({.saliency_model = VITRINE_MODELS "/u2netp.onnx", .looks_at_photos = true});
    const std::vector<std::filesystem::path> files = files_in(folder);
    std::size_t sure = 0;
    for (std::size_t i = 0; i < files.size(); i += step) {
        const cv::Mat photo = picture(files[i], photo_side);
        if (photo.empty()) continue;
        const SaliencyMap map = network->find({photo, {}, 1});
        const SubjectOutline outline = subject_outline(map);
        if (outline.certainty < sure_certainty) continue;
        const Box box = bounding_box(outline.sure);
        const std::array<double, 4> sides{box.min.x / map.cols, box.min.y / map.rows, box.max.x / map.cols,
                                          box.max.y / map.rows};
        std::array<float, 4> shares{};
        std::ranges::transform(sides, shares.begin(), [](double side) { return static_cast<float>(side); });
        write(output, shares);
        for (const SubjectWindow& window : windows_of(photo, *detector))
            write(output, window.facts);
        ++sure;
    }
    fmt::print("{} pictures with a sure subject\n", sure);
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() < 2 || words.size() > 3) {
        fmt::print(stderr, "window_facts PICTURES OUTPUT [STEP]\n");
        return 2;
    }
    cv::setNumThreads(1);
    try {
        std::ofstream output;
        output.exceptions(std::ios::failbit | std::ios::badbit);
        output.open(words[1], std::ios::binary);
        write_facts(words[0], output, words.size() == 3 ? std::stoul(words[2]) : 1);
    } catch (const std::exception& error) {
        fmt::print(stderr, "window_facts: {}\n", error.what());
        return 1;
    }
    return 0;
}
