#include "analyzer/tapestry/weave/woven_sheet.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace vitrine::analyzer {

namespace {

constexpr int gap = 60;  // px between two levels, for the lines

/// A part of a level, px of its strip.
struct Part {
    int from = 0;
    int to = 0;
};

/// The tapestry's index without files, for its mapping of times.
Tapestry index_of(const Film& film, const std::vector<Keyframes>& levels) {
    Tapestry index{.duration = film.duration, .brick_width = film.candidates->brick().width};
    for (const Keyframes& keyframes : levels)
        index.levels.push_back(level_of(keyframes, *film.candidates));
    return index;
}

/// The parts, each as wide as the coarsest level, around the middle of the part above.
std::vector<Part> parts_of(const Tapestry& index) {
    const int width = index.levels[0].width;
    std::vector<Part> parts{{0, width}};
    for (std::size_t i = 1; i < index.levels.size(); ++i) {
        const auto time = index.time_at(i - 1, (parts.back().from + parts.back().to) / 2.0);
        const int max_from = std::max(0, index.levels[i].width - width);
        const int from = std::clamp(static_cast<int>(index.x_at(i, time)) - width / 2, 0, max_from);
        parts.push_back({from, std::min(from + width, index.levels[i].width)});
    }
    return parts;
}

/// Weaves only as much of a level as is seen, and the tiles before it.
cv::Mat woven_part(const Film& film, const Keyframes& keyframes, const Part& part,
                   const RetargetSettings& settings, const RunTasks& run) {
    const cv::Size brick = film.candidates->brick();
    const int first = std::max(0, 2 * part.from / brick.width / 2 * 2 - 2);
    const int last = std::min(static_cast<int>(keyframes.size()), 2 * part.to / brick.width + 3);
    const cv::Mat strip =
        woven_strip(film, Keyframes(keyframes.begin() + first, keyframes.begin() + last), settings, run);
    const int shift = part.from - first * brick.width / 2;
    return strip.colRange(shift, std::min(strip.cols, shift + part.to - part.from));
}

}  // namespace

cv::Mat drawn_weave(const Film& film, const std::vector<Keyframes>& levels, const RetargetSettings& settings,
                    const RunTasks& run) {
    const Tapestry index = index_of(film, levels);
    const std::vector<Part> parts = parts_of(index);
    const int width = index.levels[0].width;
    const int height = tapestry_height({.keyframes = 1, .brick = film.candidates->brick()});
    const int step = height + gap;
    cv::Mat sheet(static_cast<int>(levels.size()) * step - gap, width, CV_8UC3, cv::Scalar::all(255));
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const int top = static_cast<int>(i) * step;
        const cv::Mat strip = woven_part(film, levels[i], parts[i], settings, run);
        strip.copyTo(sheet(cv::Rect(0, top, strip.cols, strip.rows)));
        if (i == 0) continue;
        const auto line = [&](double x) {
            const double above = index.x_at(i - 1, index.time_at(i, x)) - parts[i - 1].from;
            cv::line(sheet, cv::Point(static_cast<int>(above), top - gap + 4),
                     cv::Point(static_cast<int>(x) - parts[i].from, top - 4), cv::Scalar::all(90), 2,
                     cv::LINE_AA);
        };
        line(parts[i].from);
        line(parts[i].to);
    }
    return sheet;
}

}  // namespace vitrine::analyzer
