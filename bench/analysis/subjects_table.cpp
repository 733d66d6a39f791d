// Measures how well the regions of labelled photographs hold the things that people look at: our regions, the
// paper's letter, and other programs that may keep as much of the picture as our region does. Also measures
// the time for a picture.

#include "analyzer/one_file/subject_network.hpp"
#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/faces.hpp"
#include "analyzer/saliency/frequency_tuned.hpp"
#include "analyzer/saliency/i_region.hpp"
#include "analyzer/saliency/motion_contrast.hpp"
#include "analyzer/saliency/salient_volume.hpp"
#include "analyzer/saliency/sample.hpp"
#include "analyzer/saliency/shot_region.hpp"
#include "bench/analysis/peer_crops.hpp"
#include "bench/analysis/region_score.hpp"
#include "bench/analysis/subject_scores.hpp"
#include "bench/analysis/tables.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <functional>
#include <memory>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr double paper_frame_ms = 300;  // 90 s for 300 frames, Dynamic Media Assemblage chapter 5
constexpr int photo_side = 640;         // px, as photographs are analysed

/// The region of a photograph, px of it, as the analyzer makes it.
/// @param network  null: not asked
Polygon region_of(const cv::Mat& photo, FaceDetector& detector, const AnalysisSettings& settings,
                  SubjectNetwork* network = nullptr) {
    const std::vector<Face> faces = find_faces(detector, photo, settings.only_prominent_faces);
    Sample sample = sample_of({photo, {}, 1}, settings, faces);
    sample.faces = faces;
    if (network != nullptr) sample.subject = network->find({photo, {}, 1});
    return shot_region({sample}, {}, map_size(photo.size()), photo.size(), settings).shot.region.polygon;
}

AnalysisSettings by(ImageSaliency image) {
    AnalysisSettings settings;
    settings.image = image;
    if (image != ImageSaliency::subject) settings.weights = {};
    return settings;
}

struct Photo {
    cv::Mat picture;
    double share = 0;  // share of the picture's area in our region
    FaceDetector& detector;
    SubjectNetwork* network = nullptr;  // null: there is none
    SubjectNetwork* student = nullptr;  // null: there is none
};

struct Way {
    const char* name;
    std::function<Polygon(const Photo&)> region;
};

const std::vector<Way>& ways() {
    static const std::vector<Way> all{
        {"ours", [](const Photo& p) { return region_of(p.picture, p.detector, {}, p.network); }},
        {"ours, student", [](const Photo& p) { return region_of(p.picture, p.detector, {}, p.student); }},
        {"ours, plain", [](const Photo& p) { return region_of(p.picture, p.detector, {}); }},
        {"ours, by barriers",
         [](const Photo& p) { return region_of(p.picture, p.detector, by(ImageSaliency::barrier)); }},
        {"the paper's letter", [](const Photo& p) { return region_of(p.picture, p.detector, paper_mode()); }},
        {"centre, same area",
         [](const Photo& p) { return to_polygon(centre_crop(p.picture.size(), p.share)); }},
        {"libvips, same area", [](const Photo& p) { return to_polygon(attention_crop(p.picture, p.share)); }},
        {"smartcrop, same area",
         [](const Photo& p) { return to_polygon(smartcrop_crop(p.picture, p.share)); }},
    };
    return all;
}

std::vector<Box> joined(std::vector<Box> a, const std::vector<Box>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

void photographs(const TableInput& input, FaceDetector& detector, SubjectNetwork* network,
                 SubjectNetwork* student) {
    const fs::path folder = input.media / "photos";
    std::ifstream file(folder / "boxes.json");
    if (!file) {
        fmt::print("photographs: not here\n");
        return;
    }
    const nlohmann::json labels = nlohmann::json::parse(file);
    std::vector<SubjectScores> scores(ways().size());
    for (const auto& [name, entry] : labels["images"].items()) {
        Photo photo{.picture = picture(folder / name, photo_side),
                    .detector = detector,
                    .network = network,
                    .student = student};
        if (photo.picture.empty()) continue;
        const cv::Size size = photo.picture.size();
        const std::vector<Box> subjects = boxes(entry, "subject");
        const cv::Mat subject = filled(size, subjects);
        const cv::Mat ignored = filled(size, boxes(entry, "also"));
        const std::vector<Box> faces = joined(boxes(entry, "face"), boxes(entry, "face_profile"));
        for (std::size_t i = 0; i < ways().size(); ++i) {
            const Polygon region = ways()[i].region(photo);
            if (i == 0) photo.share = area(region) / static_cast<double>(size.area());
            const RegionScore s = region_score(region, size, subject, ignored, faces);
            scores[i].add(s, cv::countNonZero(subject) / static_cast<double>(size.area()));
            if (!input.is_verbose || i > 0) continue;
            fmt::print("  {:40} iou {:.2f} coverage {:.2f} area {:.2f} faces {}/{}\n", name, s.iou,
                       s.coverage, s.area, s.whole_faces, s.faces);
        }
    }
    fmt::print(
        "{} photographs with a subject: share of it inside the region (the worst tenth is the mean of "
        "the worst 10 %),\nthe region's share of the picture, overlap, correlation of that share with the "
        "subject's, marked faces wholly inside\n",
        scores[0].coverage.size());
    print_scores_head();
    for (std::size_t i = 0; i < scores.size(); ++i)
        print_scores(ways()[i].name, scores[i]);
}

/// CPU time of one round.
double milliseconds(const std::function<void()>& work) {
    work();
    const std::clock_t from = std::clock();
    constexpr int rounds = 20;
    for (int i = 0; i < rounds; ++i)
        work();
    return 1000.0 * static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC / rounds;
}

/// Prints the time of each stage for a 320 px frame, one thread.
void costs(const fs::path& folder, FaceDetector& faces) {
    if (!fs::exists(folder / "frames")) return;
    const cv::Mat a = picture(folder / "frames" / "00010.jpg", 320);
    const cv::Mat b = picture(folder / "frames" / "00011.jpg", 320);
    const cv::Mat photo = picture(folder / "frames" / "00010.jpg", photo_side);
    cv::Mat grey_a;
    cv::Mat grey_b;
    cv::cvtColor(a, grey_a, cv::COLOR_BGR2GRAY);
    cv::cvtColor(b, grey_b, cv::COLOR_BGR2GRAY);
    const auto stage = [&a](ImageSaliency method) {
        const auto made = image_saliency_stage(method);
        return milliseconds([&] { made->map(a, {}); });
    };
    const double motion = milliseconds([&] { motion_contrast(grey_a, grey_b); });
    const double face = milliseconds([&] { faces.detect(a); });
    const double photo_face = milliseconds([&] { faces.detect(photo); });
    const double whole = milliseconds([&] { sample_of({b, a, 0.04}, {}); });
    std::vector<SalientFrame> frames;
    for (int i = 0; i < 64; ++i)
        frames.push_back({.map = sample_of({b, a, 0.04}, {}).image, .time = i / 8.0});
    const double drift = milliseconds([&] { found_drift(frames, 8, DriftMode::smallest_area); });
    const SaliencyMap volume = accumulated(frames, {});
    const Box core = common_part(volume.size(), {}, 0);
    const double region = milliseconds([&] { i_region(volume, core, {}, {}); });
    const double sample = whole + face / 4;
    fmt::print(
        "cost, ms of CPU on {} x {}: frequency-tuned {:.2f}, barrier {:.2f}, subject {:.2f}, motion {:.2f}, "
        "faces {:.1f}, of a photo {:.1f};\n"
        "  a sample with faces every 4th {:.1f} ms, 1/{:.0f} of the paper's 300 ms a frame; a shot of "
        "64 samples: drift {:.1f}, region {:.1f}\n",
        a.cols, a.rows, stage(ImageSaliency::frequency_tuned), stage(ImageSaliency::barrier),
        stage(ImageSaliency::subject), motion, face, photo_face, sample, paper_frame_ms / sample, drift,
        region);
}

}  // namespace

void subjects_table(const TableInput& input) {
    const auto faces = face_detector(input.face_model, AnalysisSettings{}.face_cascade);
    std::unique_ptr<SubjectNetwork> network;
    if (!input.saliency_model.empty())
        network = photo_network({.saliency_model = input.saliency_model, .looks_at_photos = true});
    const auto student = photo_network({.saliency_model = input.student_model, .is_student = true});
    photographs(input, *faces, network.get(), student.get());
    costs(input.media / "saliency" / "davis_car-shadow", *faces);
}

}  // namespace vitrine::analyzer
