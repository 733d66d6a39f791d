// Moving subjects inside the drifting region, against still boxes of the same area: takes with the subject's
// outline in every frame, real ones of the media folder and drawn ones, and films whose subjects are labelled
// in a few frames.

#include "analyzer/film/frame_reader.hpp"
#include "analyzer/one_file/analyze.hpp"
#include "base/state/media_error.hpp"
#include "bench/analysis/made_takes.hpp"
#include "bench/analysis/region_score.hpp"
#include "bench/analysis/subject_scores.hpp"
#include "bench/analysis/tables.hpp"
#include "bench/analysis/take.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <vector>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr int take_side = 640;  // px, longest side at which masks are compared

/// Shares of the subject inside, over the frames that show any of it.
struct Held {
    double mean = 0;
    double worst = 1;
    double area = 0;  // share of the picture, mean over the frames
    std::vector<double> shares;

    void add(double share, double part) {
        shares.push_back(share);
        const auto count = static_cast<double>(shares.size());
        mean += (share - mean) / count;
        area += (part - area) / count;
        worst = std::min(worst, share);
    }
};

using RegionOfFrame = std::function<Polygon(std::size_t)>;

Held held(const Take& take, const RegionOfFrame& region) {
    Held result;
    for (std::size_t i = 0; i < take.masks.size(); ++i) {
        const int whole = cv::countNonZero(take.masks[i]);
        if (whole == 0) continue;
        const cv::Mat inside = filled(take.masks[i].size(), region(i));
        result.add(cv::countNonZero(inside & take.masks[i]) / static_cast<double>(whole),
                   cv::countNonZero(inside) / static_cast<double>(inside.total()));
    }
    return result;
}

/// A box of the picture's shape about a place, pushed inside the picture.
Polygon still_box(cv::Size size, double part, Vec2 centre) {
    const Vec2 half = Vec2{size.width / 2.0, size.height / 2.0} * std::sqrt(part);
    const Vec2 at{std::clamp(centre.x, half.x, size.width - half.x),
                  std::clamp(centre.y, half.y, size.height - half.y)};
    return to_polygon({at - half, at + half});
}

Vec2 mean_place(const std::vector<cv::Mat>& masks) {
    Vec2 sum;
    double mass = 0;
    for (const cv::Mat& mask : masks) {
        const cv::Moments m = cv::moments(mask, true);
        sum = sum + Vec2{m.m10, m.m01};
        mass += m.m00;
    }
    return mass > 0 ? sum * (1 / mass) : Vec2{};
}

/// The same take by each way.
struct TakeScore {
    Held ours;   // with the network's looks
    Held plain;  // without
    Held letter;
    Held best_box;    // centred where the subject is on average
    Held middle_box;  // a box in the middle of the picture
};

/// The settings with the network that films are measured with.
AnalysisSettings with_network(const TableInput& input) {
    return {.saliency_model = input.is_student ? input.student_model : input.saliency_model,
            .is_student = input.is_student,
            .spare_model = input.is_student ? std::string() : input.student_model,
            .face_model = input.face_model};
}

TakeScore take_score(const Take& take, const EncodedTake& file, const TableInput& input) {
    const cv::Size size = take.frames.front().size();
    const auto held_by = [&](const AnalysisSettings& settings) {
        const MediaRecord record = file.analyzed(settings);
        return held(take, [&](std::size_t i) {
            const double seconds = (static_cast<double>(i) + 0.01) / take.fps;
            return region_at(record, std::chrono::nanoseconds(std::llround(seconds * 1e9)));
        });
    };
    AnalysisSettings settings;
    settings.face_model = input.face_model;
    TakeScore score{.plain = held_by(settings), .letter = held_by(paper_mode())};
    score.ours = held_by(with_network(input));
    const auto boxed = [&](Vec2 centre) {
        const Polygon box = still_box(size, score.ours.area, centre);
        return held(take, [&](std::size_t) { return box; });
    };
    score.best_box = boxed(mean_place(take.masks));
    score.middle_box = boxed({size.width / 2.0, size.height / 2.0});
    return score;
}

void print_row(const std::string& name, const TakeScore& s) {
    fmt::print(
        "  {:34} {:6.3f} {:6.3f} {:6.3f} | {:6.3f} {:6.3f} {:6.3f} | {:6.3f} {:6.3f} | {:6.3f} {:6.3f} | "
        "{:6.3f} {:6.3f}\n",
        name, s.ours.mean, s.ours.worst, s.ours.area, s.plain.mean, s.plain.worst, s.plain.area,
        s.best_box.mean, s.best_box.worst, s.middle_box.mean, s.middle_box.worst, s.letter.mean,
        s.letter.area);
}

void takes_table(const char* title, std::size_t count, const std::function<Take(std::size_t)>& take_of,
                 const TableInput& input) {
    fmt::print("{:36} {:^20} | {:^20} | box on subject | box in middle  | letter\n{:36} {:>6} {:>6} {:>6} | "
               "{:>6} {:>6} "
               "{:>6} | {:>6} {:>6} | {:>6} {:>6} | {:>6} {:>6}\n",
               title, "with the network", "plain", "", "mean", "worst", "area", "mean", "worst", "area",
               "mean", "worst", "mean", "worst", "mean", "area");
    TakeScore sum;
    TakeScore frames;  // of all takes
    constexpr std::array all{&TakeScore::ours, &TakeScore::plain, &TakeScore::best_box,
                             &TakeScore::middle_box, &TakeScore::letter};
    for (std::size_t i = 0; i < count; ++i) {
        const Take take = take_of(i);
        const EncodedTake file(take);
        const TakeScore s = take_score(take, file, input);
        print_row(take.name, s);
        for (Held TakeScore::*way : all) {
            (sum.*way).add((s.*way).mean, (s.*way).area);
            std::vector<double>& shares = (frames.*way).shares;
            shares.insert(shares.end(), (s.*way).shares.begin(), (s.*way).shares.end());
        }
    }
    for (Held TakeScore::*way : all)
        (sum.*way).worst = lowest_tenth((frames.*way).shares);
    print_row(fmt::format("mean of {}, worst tenth of frames", count), sum);
}

/// A source that notes when each of its frames is shown.
class TimedSource : public FrameSource {
  public:
    explicit TimedSource(std::unique_ptr<FrameSource> source) : source_(std::move(source)) {}

    const MediaInfo& info() const override { return source_->info(); }

    std::optional<FilmFrame> next() override {
        std::optional<FilmFrame> frame = source_->next();
        if (frame) times_.push_back(frame->time);
        return frame;
    }

    std::chrono::nanoseconds time(std::size_t frame) const { return times_.at(frame); }

  private:
    std::unique_ptr<FrameSource> source_;
    std::vector<std::chrono::nanoseconds> times_;
};

/// The scores of a film's labelled frames.
std::vector<RegionScore> film_scores(const fs::path& film, const nlohmann::json& frames,
                                     const AnalysisSettings& settings) {
    TimedSource source(open_media(film.string(), settings.frame_size));
    const MediaRecord record = analyze(source, settings);
    const cv::Size size(record.width, record.height);
    std::vector<RegionScore> scores;
    for (const auto& [index, entry] : frames.items()) {
        const std::vector<Box> subjects = boxes(nlohmann::json{{"subject", entry}}, "subject");
        const Polygon region = region_at(record, source.time(std::stoul(index)));
        if (subjects.empty() || region.empty()) continue;
        scores.push_back(
            region_score(region, size, filled(size, subjects), cv::Mat::zeros(size, CV_8UC1), {}));
    }
    return scores;
}

/// Films whose subjects are labelled in a few frames. A film that is not decoded here is named.
void films(const TableInput& input, const AnalysisSettings& settings, const char* name) {
    std::ifstream file(input.media / "photos" / "boxes.json");
    if (!file) return;
    const nlohmann::json labels = nlohmann::json::parse(file);
    RegionScore sum;
    double least = 1;
    for (const auto& [path, frames] : labels["video_frames"].items()) {
        std::string row;
        try {
            for (const RegionScore& s : film_scores(input.media / path, frames, settings)) {
                row += fmt::format("  cov {:.2f} area {:.2f}", s.coverage, s.area);
                sum.add(s);
                least = std::min(least, s.coverage);
            }
        } catch (const MediaError& error) {
            fmt::print("  {}: {}\n", path, error.what());
            continue;
        }
        if (input.is_verbose) fmt::print("  {:32}{}\n", path, row);
    }
    fmt::print("labelled frames of films, {:16} IoU {:.3f} coverage {:.3f} worst {:.3f} area {:.3f}  n={}\n",
               name, sum.iou / sum.count, sum.coverage / sum.count, least, sum.area / sum.count, sum.count);
}

}  // namespace

void motion_table(const TableInput& input) {
    std::vector<fs::path> folders;
    if (fs::is_directory(input.media / "saliency")) {
        for (const fs::path& folder : fs::directory_iterator(input.media / "saliency")) {
            if (fs::is_directory(folder / "frames") && fs::is_directory(folder / "masks"))
                folders.push_back(folder);
        }
    }
    std::sort(folders.begin(), folders.end());
    takes_table(
        "filmed subjects", folders.size(), [&](std::size_t i) { return read_take(folders[i], take_side); },
        input);
    const Palette drawn_with = palette(input.media, take_side);
    takes_table(
        "drawn subjects", made_take_count(), [&](std::size_t i) { return made_take(i, drawn_with); }, input);
    films(input, paper_mode(), "paper's letter");
    films(input, {.face_model = input.face_model}, "plain");
    films(input, with_network(input), input.is_student ? "with the student" : "with the network");
}

}  // namespace vitrine::analyzer
