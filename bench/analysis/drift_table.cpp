// The drift found on pictures that move by known velocities, in px per frame of a window 80 px wide.

#include "analyzer/one_file/analyze.hpp"
#include "analyzer/saliency/motion_contrast.hpp"
#include "bench/analysis/made_takes.hpp"
#include "bench/analysis/tables.hpp"
#include "bench/analysis/take.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace vitrine::analyzer {

namespace {

constexpr int window_width = 80;  // px in which drifts are told
constexpr int window_height = 45;
constexpr int frames = 60;
constexpr int pans_of_a_kind = 12;
constexpr double max_travel = 0.36;  // share of each side over the take: beyond 40 % no drift may follow

/// A kind of take: the changes that come with its motion.
struct Kind {
    const char* name;
    double noise = 1;         // grey levels
    double zoom = 1;          // at the end
    double light = 1;         // at the end
    bool is_subject = false;  // true: the camera stands and a cut-out moves
};

constexpr std::array<Kind, 5> kinds{{{"pan"},
                                     {"pan, noisy", 5},
                                     {"pan, light changes", 1, 1, 1.3},
                                     {"pan, zooms", 1, 1.12},
                                     {"subject moves, camera stands", 2, 1, 1, true}}};

struct Pan {
    Take take;
    Vec2 velocity;  // px of the window per frame
};

void finish_frame(cv::Mat& frame, const Kind& kind, double t, cv::RNG& random) {
    cv::Mat noise(frame.size(), CV_16SC3);
    random.fill(noise, cv::RNG::NORMAL, 0, kind.noise);
    cv::Mat sum;
    frame.convertTo(sum, CV_16SC3, 1 + (kind.light - 1) * t);
    sum += noise;
    sum.convertTo(frame, CV_8UC3);
}

/// @param scale  px of the rendered frames per px of the window
Pan rendered(const Kind& kind, unsigned seed, int scale, const Palette& palette) {
    cv::RNG random(seed);
    Pan pan{.take = {.name = kind.name, .frames = {}, .masks = {}}, .velocity = {}};
    pan.velocity = {random.uniform(-max_travel, max_travel) * window_width / frames,
                    random.uniform(-max_travel, max_travel) * window_height / frames};
    const std::vector<cv::Mat>& worlds = kind.is_subject ? palette.scenes : palette.subjects;
    const cv::Mat& world =
        worlds[static_cast<std::size_t>(random.uniform(0, static_cast<int>(worlds.size())))];
    const cv::Mat& model =
        palette
            .subjects[static_cast<std::size_t>(random.uniform(0, static_cast<int>(palette.subjects.size())))];
    const cv::Size size(window_width * scale, window_height * scale);
    const double fit = 1.5 * size.width / world.cols;
    const Vec2 middle{size.width / 2.0, size.height / 2.0};
    cv::Mat mip;
    cv::resize(world, mip, {}, std::min(1.0, 2 * fit), std::min(1.0, 2 * fit), cv::INTER_AREA);
    cv::GaussianBlur(mip, mip, {0, 0}, 1);
    const double zoom = fit * world.cols / mip.cols;
    for (int i = 0; i < frames; ++i) {
        const double t = i / (frames - 1.0);
        const Vec2 moved = pan.velocity * (scale * (i - frames / 2.0));
        const double s = zoom * std::pow(kind.zoom, t);
        const Vec2 at =
            middle - Vec2{mip.cols / 2.0, mip.rows / 2.0} * s + (kind.is_subject ? Vec2{} : moved);
        cv::Mat frame;
        cv::warpAffine(mip, frame, cv::Matx23d(s, 0, at.x, 0, s, at.y), size, cv::INTER_LINEAR,
                       cv::BORDER_REFLECT_101);
        if (kind.is_subject) {
            const double r = 0.16 * size.height;
            cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
            const Vec2 centre = middle + moved;
            cv::circle(mask, cv::Point2d(centre.x * 16, centre.y * 16), static_cast<int>(r * 16), 255,
                       cv::FILLED, cv::LINE_AA, 4);
            const double k = 2.4 * r / std::min(model.cols, model.rows);
            cv::Mat moved_model;
            cv::warpAffine(
                model, moved_model,
                cv::Matx23d(k, 0, centre.x - k * model.cols / 2, 0, k, centre.y - k * model.rows / 2), size,
                cv::INTER_AREA);
            moved_model.copyTo(frame, mask);
        }
        finish_frame(frame, kind, t, random);
        pan.take.frames.push_back(frame);
    }
    return pan;
}

Vec2 drift_by(const Pan& pan, const AnalysisSettings& settings) {
    TakeSource source(pan.take);
    const MediaRecord record = analyze(source, settings);
    const double scale = static_cast<double>(record.width) / window_width;
    return record.shots.front().region.drift * (1 / (scale * pan.take.fps));
}

/// The median of the motions voted between neighbouring frames.
Vec2 voted_by(const Pan& pan) {
    std::vector<double> xs;
    std::vector<double> ys;
    cv::Mat before;
    for (const cv::Mat& frame : pan.take.frames) {
        cv::Mat now;
        cv::cvtColor(frame, now, cv::COLOR_BGR2GRAY);
        if (!before.empty()) {
            const Vec2 g = motion_contrast(before, now).global_motion;
            xs.push_back(g.x * window_width / now.cols);
            ys.push_back(g.y * window_width / now.cols);
        }
        before = now;
    }
    std::sort(xs.begin(), xs.end());
    std::sort(ys.begin(), ys.end());
    return {xs[xs.size() / 2], ys[ys.size() / 2]};
}

/// Mean and worst error of one way over the pans of a kind.
struct Error {
    double mean = 0;
    double worst = 0;
    int count = 0;

    void add(double error) {
        mean += (error - mean) / ++count;
        worst = std::max(worst, error);
    }
};

using Errors = std::array<Error, 4>;  // standing still, the paper's line, the vote, ours

void print_errors(const char* name, const Errors& errors) {
    fmt::print("  {:32}", name);
    for (const Error& error : errors)
        fmt::print("  {:6.3f} {:6.3f}", error.mean, error.worst);
    fmt::print("\n");
}

}  // namespace

void drift_table(const TableInput& input) {
    const Palette drawn_with = palette(input.media, 640);
    AnalysisSettings line;
    line.image = ImageSaliency::frequency_tuned;
    line.motion = MotionMethod::voted_pan;
    line.drift = DriftMode::box_centres;
    for (const int scale : {1, 4}) {
        fmt::print(
            "drift error, px of {} per frame, rendered {} px wide: mean and worst\n{:34}  {:^13}  {:^13}  "
            "{:^13}  {:^13}\n",
            window_width, window_width * scale, "", "still", "paper's line", "voted", "ours");
        Errors all{};
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            Errors errors{};
            for (unsigned i = 0; i < pans_of_a_kind; ++i) {
                const Pan pan = rendered(kinds[k], 100 * static_cast<unsigned>(k) + i, scale, drawn_with);
                const std::array<Vec2, 4> found{Vec2{}, drift_by(pan, line), voted_by(pan),
                                                drift_by(pan, {})};
                for (std::size_t way = 0; way < found.size(); ++way) {
                    const double error = length(found[way] - pan.velocity);
                    errors[way].add(error);
                    all[way].add(error);
                }
                if (input.is_verbose) {
                    fmt::print("    {:+.3f} {:+.3f}: ours {:+.3f} {:+.3f}, voted {:+.3f} {:+.3f}\n",
                               pan.velocity.x, pan.velocity.y, found[3].x, found[3].y, found[2].x,
                               found[2].y);
                }
            }
            print_errors(kinds[k].name, errors);
        }
        print_errors("all", all);
    }
}

}  // namespace vitrine::analyzer
