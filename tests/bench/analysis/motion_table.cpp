// Moving subjects inside the drifting region: one that the camera follows, with its outline in every frame,
// and films whose subjects are labelled in a few frames.

#include "analyzer/analyze.hpp"
#include "analyzer/saliency/faces.hpp"
#include "analyzer/saliency/sample.hpp"
#include "analyzer/saliency/shot_region.hpp"
#include "analyzer/video/frame_reader.hpp"
#include "tests/bench/analysis/region_score.hpp"
#include "tests/bench/analysis/tables.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>

namespace vitrine {

namespace fs = std::filesystem;

namespace {

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
    RegionScore sum;
    for (const auto& [path, frames] : labels["video_frames"].items()) {
        TimedSource source(open_media((media / path).string(), settings.frame_size));
        const MediaRecord record = analyze(source, settings);
        fmt::print("  {:32}", path);
        for (const auto& [index, entry] : frames.items()) {
            const std::vector<Box> subjects = boxes(nlohmann::json{{"subject", entry}}, "subject");
            const Polygon region = region_at(record, source.time(std::stoul(index)));
            if (subjects.empty() || region.empty()) continue;
            const cv::Size size(record.width, record.height);
            const RegionScore s =
                region_score(region, size, filled(size, subjects), cv::Mat::zeros(size, CV_8UC1), {});
            fmt::print("  iou {:.2f} cov {:.2f} area {:.2f}", s.iou, s.coverage, s.area);
            sum.add(s);
        }
        fmt::print("\n");
    }
    fmt::print("films, {:16} {:6.3f} {:9.3f} {:6.3f}  n={} frames\n", name, sum.iou / sum.count,
               sum.coverage / sum.count, sum.area / sum.count, sum.count);
}

}  // namespace

void motion_table(const TableInput& input) {
    const auto faces = face_detector(input.face_model, AnalysisSettings{}.face_cascade);
    moving_car(input.media / "saliency" / "davis_car-shadow", faces.get());
    films(input.media, papers_letter(), "paper's letter");
    films(input.media, {.face_model = input.face_model}, "ours");
}

}  // namespace vitrine
