// How well the regions of labelled photographs and of a moving car hold what people look at, and what a frame
// costs. Usage: regions_bench [FACE_MODEL]. Prints the paper's letter, the middle of the picture and ours
// side by side.

#include "analyzer/analyze.hpp"
#include "analyzer/saliency/faces.hpp"
#include "analyzer/saliency/frequency_tuned.hpp"
#include "analyzer/saliency/i_region.hpp"
#include "analyzer/saliency/image_saliency.hpp"
#include "analyzer/saliency/motion_contrast.hpp"
#include "analyzer/saliency/salient_volume.hpp"
#include "analyzer/saliency/sample.hpp"
#include "analyzer/saliency/shot_region.hpp"
#include "analyzer/video/frame_reader.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <vips/vips.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>

using namespace vitrine;
namespace fs = std::filesystem;

namespace {

constexpr double paper_frame_ms = 300;  // 90 s for 300 frames, Dynamic Media Assemblage chapter 5

cv::Mat picture(const fs::path& path, int side) {
    VipsImage* image = nullptr;
    if (vips_thumbnail(path.c_str(), &image, side, "height", side, "size", VIPS_SIZE_DOWN, nullptr) != 0)
        return {};
    VipsImage* rgb = nullptr;
    const int failed = vips_colourspace(image, &rgb, VIPS_INTERPRETATION_sRGB, nullptr);
    g_object_unref(image);
    VipsImage* three = nullptr;
    if (failed != 0 || vips_extract_band(rgb, &three, 0, "n", 3, nullptr) != 0) {
        fmt::print("'{}': {}\n", path.string(), vips_error_buffer());
        return {};
    }
    g_object_unref(rgb);
    std::size_t size = 0;
    void* data = vips_image_write_to_memory(three, &size);
    cv::Mat result;
    cv::cvtColor(cv::Mat(three->Ysize, three->Xsize, CV_8UC3, data), result, cv::COLOR_RGB2BGR);
    g_free(data);
    g_object_unref(three);
    return result;
}

std::vector<Box> boxes(const nlohmann::json& entry, const char* key) {
    std::vector<Box> result;
    if (!entry.contains(key)) return result;
    for (const auto& b : entry[key]) {
        result.push_back(
            {{b[0].get<double>(), b[1].get<double>()}, {b[2].get<double>(), b[3].get<double>()}});
    }
    return result;
}

cv::Mat filled(cv::Size size, const std::vector<Box>& fractions) {
    cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
    for (const Box& b : fractions) {
        const cv::Point from(static_cast<int>(b.min.x * size.width), static_cast<int>(b.min.y * size.height));
        const cv::Point to(static_cast<int>(b.max.x * size.width), static_cast<int>(b.max.y * size.height));
        mask(cv::Rect(from, to) & cv::Rect({}, size)).setTo(255);
    }
    return mask;
}

cv::Mat filled(cv::Size size, const Polygon& polygon) {
    std::vector<cv::Point> points;
    for (const Vec2 p : polygon)
        points.emplace_back(cv::Point2d(p.x - 0.5, p.y - 0.5));
    cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
    cv::fillConvexPoly(mask, points, 255);
    return mask;
}

struct Score {
    double iou = 0;
    double coverage = 0;  // of the subject
    double area = 0;      // of the picture
    int whole_faces = 0;
    int faces = 0;
    int count = 0;

    void add(const Score& s) {
        iou += s.iou;
        coverage += s.coverage;
        area += s.area;
        whole_faces += s.whole_faces;
        faces += s.faces;
        ++count;
    }
};

Score score(const Polygon& region, cv::Size size, const cv::Mat& subject, const cv::Mat& ignored,
            const std::vector<Box>& faces) {
    cv::Mat mine = filled(size, region);
    Score s{.area = cv::countNonZero(mine) / static_cast<double>(mine.total())};
    mine.setTo(0, ignored & ~subject);
    const int both = cv::countNonZero(mine & subject);
    s.iou = both / static_cast<double>(std::max(1, cv::countNonZero(mine | subject)));
    s.coverage = both / static_cast<double>(std::max(1, cv::countNonZero(subject)));
    s.faces = static_cast<int>(faces.size());
    for (const Box& face : faces) {
        const Polygon corners = to_polygon(face);
        s.whole_faces += std::all_of(corners.begin(), corners.end(), [&](Vec2 p) {
            return is_inside_convex(region, {p.x * size.width, p.y * size.height}, 1.5);
        });
    }
    return s;
}

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
    std::vector<Score> sums(ways().size());
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
            const Score s = score(region, bgr.size(), filled(bgr.size(), subjects),
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
        const Score& s = sums[i];
        fmt::print("{:24} {:6.3f} {:9.3f} {:6.3f} {:6}/{}  n={}\n", ways()[i].name, s.iou / s.count,
                   s.coverage / s.count, s.area / s.count, s.whole_faces, s.faces, s.count);
    }
}

/// A car that the camera follows, with its outline in every frame.
void moving_car(const fs::path& folder, FaceDetector* faces) {
    if (!fs::exists(folder / "frames")) {
        fmt::print("moving car: not here\n");
        return;
    }
    std::vector<fs::path> frames(fs::directory_iterator(folder / "frames"), {});
    std::vector<fs::path> masks(fs::directory_iterator(folder / "masks"), {});
    std::sort(frames.begin(), frames.end());
    std::sort(masks.begin(), masks.end());
    constexpr std::chrono::milliseconds interval{40};
    std::vector<Sample> samples;
    cv::Mat before;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const cv::Mat frame = picture(frames[i], 320);
        samples.push_back(searched(frame, before, 0.04, {}));
        samples.back().time = interval * i;
        samples.back().pair_time = interval * (i > 0 ? i - 1 : 0);
        samples.back().faces_time = samples.back().time;
        if (faces != nullptr) samples.back().faces = searched_faces(*faces, frame, true);
        before = frame;
    }
    const Shot shot{.end = interval * frames.size()};
    const ShotEvidence found = shot_region(samples, shot, map_size(before.size()), before.size(), {});
    double covered = 0;
    double least = 1;
    for (std::size_t i = 0; i < masks.size(); ++i) {
        cv::Mat mask;
        cv::cvtColor(picture(masks[i], 320), mask, cv::COLOR_BGR2GRAY);
        mask = mask > 0;
        const Vec2 moved_by = found.shot.region.drift * (0.04 * static_cast<double>(i));
        const cv::Mat inside =
            filled(mask.size(), transformed(found.shot.region.polygon, 1, moved_by)) & mask;
        const double share =
            cv::countNonZero(inside) / static_cast<double>(std::max(1, cv::countNonZero(mask)));
        covered += share / static_cast<double>(masks.size());
        least = std::min(least, share);
    }
    fmt::print("moving car: {:.0f} % of it covered on average, {:.0f} % in the worst of {} frames; region "
               "{:.0f} % of "
               "the picture, drift {:.0f}, {:.0f} px/s\n",
               covered * 100, least * 100, masks.size(),
               100 * area(found.shot.region.polygon) / static_cast<double>(before.total()),
               found.shot.region.drift.x, found.shot.region.drift.y);
}

/// A source that notes when each of its frames is shown.
class TimedSource : public FrameSource {
  public:
    explicit TimedSource(std::unique_ptr<FrameSource> source) : source_(std::move(source)) {}

    const MediaInfo& info() const override { return source_->info(); }

    std::optional<VideoFrame> next() override {
        std::optional<VideoFrame> frame = source_->next();
        if (frame) times_.push_back(frame->time);
        return frame;
    }

    std::chrono::nanoseconds time(std::size_t frame) const { return times_.at(frame); }

  private:
    std::unique_ptr<FrameSource> source_;
    std::vector<std::chrono::nanoseconds> times_;
};

/// The region of a film at one time, px of the source; empty between shots.
Polygon region_at(const MediaRecord& record, std::chrono::nanoseconds time) {
    for (const Shot& shot : record.shots) {
        if (time < shot.begin || time >= shot.end) continue;
        const double since = std::chrono::duration<double>(time - shot.begin).count();
        return transformed(shot.region.polygon, 1, shot.region.drift * since);
    }
    return {};
}

/// Films whose subjects are labelled in a few frames.
void films(const fs::path& media, const AnalysisSettings& settings, const char* name) {
    std::ifstream file(media / "photos" / "boxes.json");
    if (!file) return;
    const nlohmann::json labels = nlohmann::json::parse(file);
    Score sum;
    for (const auto& [path, frames] : labels["video_frames"].items()) {
        TimedSource source(open_media((media / path).string(), settings.frame_size));
        const MediaRecord record = analyze(source, settings);
        fmt::print("  {:32}", path);
        for (const auto& [index, entry] : frames.items()) {
            const std::vector<Box> subjects = boxes(nlohmann::json{{"subject", entry}}, "subject");
            const Polygon region = region_at(record, source.time(std::stoul(index)));
            if (subjects.empty() || region.empty()) continue;
            const cv::Size size(record.width, record.height);
            const Score s = score(region, size, filled(size, subjects), cv::Mat::zeros(size, CV_8UC1), {});
            fmt::print("  iou {:.2f} cov {:.2f} area {:.2f}", s.iou, s.coverage, s.area);
            sum.add(s);
        }
        fmt::print("\n");
    }
    fmt::print("films, {:16} {:6.3f} {:9.3f} {:6.3f}  n={} frames\n", name, sum.iou / sum.count,
               sum.coverage / sum.count, sum.area / sum.count, sum.count);
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

int main(int argc, char** argv) {
    if (VIPS_INIT(argv[0]) != 0) return 1;
    cv::setNumThreads(1);
    const fs::path media = VITRINE_SHARED_MEDIA;
    const auto faces = face_detector(argc > 1 ? argv[1] : "",
                                     "/usr/share/opencv4/haarcascades/haarcascade_frontalface_alt2.xml");
    photographs(media / "photos", faces.get(), argc > 2);
    moving_car(media / "saliency" / "davis_car-shadow", faces.get());
    films(media, papers_letter(), "paper's letter");
    films(media, {.face_model = argc > 1 ? argv[1] : ""}, "ours");
    costs(media / "saliency" / "davis_car-shadow", *faces);
    return 0;
}
