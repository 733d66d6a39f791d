// How well the regions of labelled photographs hold what people look at, and what a picture costs: the
// paper's letter, the middle of the picture and ours side by side.

#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/faces.hpp"
#include "analyzer/saliency/frequency_tuned.hpp"
#include "analyzer/saliency/i_region.hpp"
#include "analyzer/saliency/image_saliency.hpp"
#include "analyzer/saliency/motion_contrast.hpp"
#include "analyzer/saliency/salient_volume.hpp"
#include "analyzer/saliency/sample.hpp"
#include "tests/bench/analysis/region_score.hpp"
#include "tests/bench/analysis/tables.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>

namespace vitrine {

namespace fs = std::filesystem;

namespace {

constexpr double paper_frame_ms = 300;  // 90 s for 300 frames, Dynamic Media Assemblage chapter 5

Polygon centre_box(cv::Size size, double side) {
    const Vec2 s{static_cast<double>(size.width), static_cast<double>(size.height)};
    return to_polygon({s * (0.5 - side / 2), s * (0.5 + side / 2)});
}

struct Way {
    const char* name;
    std::function<Polygon(const cv::Mat&, const cv::Mat&, FaceDetector*)> region;
};

Polygon region_of(const cv::Mat& bgr, const cv::Mat& large, FaceDetector* faces, ImageSaliency method,
                  const RegionSettings& settings) {
    const double scale = static_cast<double>(large.cols) / bgr.cols;
    std::vector<Face> found;
    const bool is_ours = method == ImageSaliency::barrier;
    if (faces != nullptr) found = faces->detect(large);
    if (is_ours) found = prominent(std::move(found));
    cv::Mat map =
        combined({}, image_saliency(bgr, method), face_saliency(found, bgr.size(), scale, is_ours), {});
    const double shrink = std::min(1.0, 160.0 / std::max(map.cols, map.rows));
    cv::resize(map, map, {}, shrink, shrink, cv::INTER_AREA);
    std::vector<Box> whole;
    for (const Face& f : found) {
        const Box head = head_of(f);
        whole.push_back({head.min * (shrink / scale), head.max * (shrink / scale)});
    }
    const Box core{{0, 0}, {static_cast<double>(map.cols), static_cast<double>(map.rows)}};
    return transformed(i_region(map, core, whole, settings), 1 / shrink, {});
}

const std::vector<Way>& ways() {
    using M = cv::Mat;
    static const std::vector<Way> all{
        {"the paper's letter",
         [](const M& b, const M& l, FaceDetector* f) {
             return region_of(b, l, f, ImageSaliency::frequency_tuned, {.mode = RegionMode::hull});
         }},
        {"whole picture", [](const M& b, const M&, FaceDetector*) { return centre_box(b.size(), 1); }},
        {"middle, 60 % of sides",
         [](const M& b, const M&, FaceDetector*) { return centre_box(b.size(), 0.6); }},
        {"middle, 60 % of area",
         [](const M& b, const M&, FaceDetector*) { return centre_box(b.size(), 0.7746); }},
        {"tuned, min_area",
         [](const M& b, const M& l, FaceDetector* f) {
             return region_of(b, l, f, ImageSaliency::frequency_tuned, {});
         }},
        {"barrier, hull",
         [](const M& b, const M& l, FaceDetector* f) {
             return region_of(b, l, f, ImageSaliency::barrier, {.mode = RegionMode::hull});
         }},
        {"ours", [](const M& b, const M& l,
                    FaceDetector* f) { return region_of(b, l, f, ImageSaliency::barrier, {}); }},
    };
    return all;
}

void photographs(const fs::path& folder, FaceDetector* faces, bool is_verbose) {
    std::ifstream file(folder / "boxes.json");
    if (!file) {
        fmt::print("photographs: not here\n");
        return;
    }
    const nlohmann::json labels = nlohmann::json::parse(file);
    std::vector<RegionScore> sums(ways().size());
    for (const auto& [name, entry] : labels["images"].items()) {
        const cv::Mat large = picture(folder / name, 640);
        if (large.empty()) continue;
        const std::vector<Box> subjects = boxes(entry, "subject");
        cv::Mat bgr;
        const double shrink = std::min(1.0, 320.0 / std::max(large.cols, large.rows));
        cv::resize(large, bgr, {}, shrink, shrink, cv::INTER_AREA);
        std::vector<Box> heads = boxes(entry, "face");
        for (const Box& b : boxes(entry, "face_profile"))
            heads.push_back(b);
        for (std::size_t i = 0; i < ways().size(); ++i) {
            const Polygon region = ways()[i].region(bgr, large, faces);
            const RegionScore s = region_score(region, bgr.size(), filled(bgr.size(), subjects),
                                               filled(bgr.size(), boxes(entry, "also")), heads);
            if (is_verbose && i + 1 == ways().size()) {
                fmt::print("  {:40} iou {:.2f} coverage {:.2f} area {:.2f} faces {}/{}\n", name, s.iou,
                           s.coverage, s.area, s.whole_faces, s.faces);
            }
            if (!subjects.empty()) sums[i].add(s);
        }
    }
    fmt::print("{:24} {:>6} {:>9} {:>6} {:>12}\n", "photographs", "IoU", "coverage", "area", "whole faces");
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const RegionScore& s = sums[i];
        fmt::print("{:24} {:6.3f} {:9.3f} {:6.3f} {:6}/{}  n={}\n", ways()[i].name, s.iou / s.count,
                   s.coverage / s.count, s.area / s.count, s.whole_faces, s.faces, s.count);
    }
}

double milliseconds(const std::function<void()>& work) {
    work();
    const auto from = std::chrono::steady_clock::now();
    constexpr int rounds = 20;
    for (int i = 0; i < rounds; ++i)
        work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count() /
           rounds;
}

/// What each stage costs on a 320 px frame, one thread.
void costs(const fs::path& folder, FaceDetector& faces) {
    if (!fs::exists(folder / "frames")) return;
    const cv::Mat a = picture(folder / "frames" / "00010.jpg", 320);
    const cv::Mat b = picture(folder / "frames" / "00011.jpg", 320);
    cv::Mat grey_a;
    cv::Mat grey_b;
    cv::cvtColor(a, grey_a, cv::COLOR_BGR2GRAY);
    cv::cvtColor(b, grey_b, cv::COLOR_BGR2GRAY);
    const double tuned = milliseconds([&] { frequency_tuned(lab(a)); });
    const double barrier = milliseconds([&] { image_saliency(a, ImageSaliency::barrier); });
    const double motion = milliseconds([&] { motion_contrast(grey_a, grey_b); });
    const double face = milliseconds([&] { faces.detect(a); });
    const double whole = milliseconds([&] { searched(b, a, 0.04, {}); });
    std::vector<SalientFrame> frames;
    for (int i = 0; i < 64; ++i)
        frames.push_back({.map = searched(b, a, 0.04, {}).image, .time = i / 8.0});
    const double drift = milliseconds([&] { found_drift(frames, 8, DriftMode::smallest_area); });
    const SaliencyMap volume = accumulated(frames, {});
    const Box core = common_part(volume.size(), {}, 0);
    const double region = milliseconds([&] { i_region(volume, core, {}, {}); });
    const double sample = whole + face / 4;
    fmt::print("cost, ms of one thread on {} x {}: frequency-tuned {:.2f}, barrier {:.2f}, motion {:.2f}, "
               "faces {:.1f};\n"
               "  a sample with faces every 4th {:.1f} ms, 1/{:.0f} of the paper's 300 ms a frame; a shot of "
               "64 samples: "
               "drift {:.1f}, region {:.1f}\n",
               a.cols, a.rows, tuned, barrier, motion, face, sample, paper_frame_ms / sample, drift, region);
}

}  // namespace

void subjects_table(const TableInput& input) {
    const auto faces = face_detector(input.face_model, AnalysisSettings{}.face_cascade);
    photographs(input.media / "photos", faces.get(), input.is_verbose);
    costs(input.media / "saliency" / "davis_car-shadow", *faces);
}

}  // namespace vitrine
