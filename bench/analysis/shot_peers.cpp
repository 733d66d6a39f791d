#include "bench/analysis/shot_peers.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <array>
#include <cstdio>
#include <memory>

namespace vitrine::analyzer {

namespace {

using std::chrono::nanoseconds;

constexpr std::ptrdiff_t adaptive_reach = 2;  // frames to either side
constexpr double min_content = 15;

std::string quoted(const std::string& path) {
    std::string out = "'";
    for (const char c : path)
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

}  // namespace

std::vector<Suspicion> scdet_scores(const std::string& path) {
    const std::string command =
        fmt::format("ffmpeg -nostdin -hide_banner -i {} -vf scdet=t=1 -an -f null - 2>&1", quoted(path));
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
    std::vector<Suspicion> scores;
    std::array<char, 1024> line{};
    while (pipe && std::fgets(line.data(), line.size(), pipe.get()) != nullptr) {
        const std::string text(line.data());
        const auto at = text.find("lavfi.scd.score: ");
        double score = 0;
        double seconds = 0;
        if (at == std::string::npos) continue;
        if (std::sscanf(text.c_str() + at, "lavfi.scd.score: %lf, lavfi.scd.time: %lf", &score, &seconds) ==
            2)
            scores.push_back({nanoseconds(static_cast<std::int64_t>(seconds * 1e9)), score});
    }
    return scores;
}

void AdaptiveDetector::push(const FilmFrame& frame) {
    cv::Mat hsv;
    cv::cvtColor(frame.picture, hsv, cv::COLOR_BGR2HSV);
    double change = 0;
    if (!last_.empty()) {
        cv::Mat difference;
        cv::absdiff(hsv, last_, difference);
        const cv::Scalar mean = cv::mean(difference);
        change = (mean[0] + mean[1] + mean[2]) / 3;
    }
    last_ = hsv;
    changes_.push_back({frame.time, change});
}

std::vector<Suspicion> AdaptiveDetector::finish() const {
    std::vector<Suspicion> out;
    const auto count = static_cast<std::ptrdiff_t>(changes_.size());
    const auto change = [&](std::ptrdiff_t i) { return changes_[static_cast<std::size_t>(i)].score; };
    for (std::ptrdiff_t i = adaptive_reach; i + adaptive_reach < count; ++i) {
        double around = -change(i);
        for (std::ptrdiff_t j = i - adaptive_reach; j <= i + adaptive_reach; ++j)
            around += change(j);
        const double ratio = change(i) / std::max(around / (2 * adaptive_reach), 1e-3);
        out.push_back({changes_[static_cast<std::size_t>(i)].time, change(i) < min_content ? 0 : ratio});
    }
    return out;
}

void HistogramDetector::push(const FrameFeatures& frame) {
    if (is_begun_) steps_.push_back({frame.time, colour_difference(last_, frame)});
    is_begun_ = true;
    last_ = frame;
}

}  // namespace vitrine::analyzer
