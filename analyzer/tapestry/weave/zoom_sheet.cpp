#include "analyzer/tapestry/weave/zoom_sheet.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::analyzer {

namespace {

constexpr int max_sheet_width = 960;  // px of the sheet
constexpr int gap = 4;                // px between rows
constexpr std::array<double, 3> moments{0.25, 0.5, 0.75};

/// The place where the finer level adds most, px of the coarser strip.
double busiest(const StripZoom& zoom) {
    const ZoomPart& part = *std::ranges::max_element(zoom.parts(), {}, [](const ZoomPart& one) {
        return static_cast<double>(one.used_fine.size()) / one.part.used.size();
    });
    return (part.part.used.start + part.part.used.end) / 2.0;
}

/// The part of a strip around a place of the coarser one.
cv::Mat seen(const cv::Mat& strip, const LevelPair& pair, double middle, double share, int width) {
    const double fine = pair.index.x_at(1, pair.index.time_at(0, middle));
    const int from = static_cast<int>((1 - share) * middle + share * fine) - width / 2;
    const int begin = std::clamp(from, 0, strip.cols - width);
    return strip.colRange(begin, begin + width);
}

/// Blends both levels at the scale at which a viewer sees them at that moment.
cv::Mat faded(const LevelPair& pair, double share) {
    const cv::Size size(
        static_cast<int>(std::lround((1 - share) * pair.coarse.cols + share * pair.fine.cols)),
        pair.coarse.rows);
    cv::Mat coarse;
    cv::Mat fine;
    cv::resize(pair.coarse, coarse, size, 0, 0, cv::INTER_LINEAR);
    cv::resize(pair.fine, fine, size, 0, 0, cv::INTER_AREA);
    cv::Mat mixed;
    cv::addWeighted(coarse, 1 - share, fine, share, 0, mixed);
    return mixed;
}

}  // namespace

cv::Mat drawn_zoom(const LevelPair& pair, const RunTasks& run, const ZoomRules& rules) {
    const StripZoom zoom(pair, run);
    const ZoomPictures bent = zoom.bent(rules.between);
    const ZoomPictures synthesised = zoom.synthesised(rules, run);
    const int width = std::min(max_sheet_width, pair.coarse.cols);
    const auto picture = [&](const ZoomPictures& pictures, double share) {
        return pictures[static_cast<std::size_t>(std::lround(share * (rules.between + 1)))];
    };
    const double middle = busiest(zoom);
    std::vector<cv::Mat> rows{seen(pair.coarse, pair, middle, 0, width)};
    for (const double share : moments)
        rows.push_back(seen(faded(pair, share), pair, middle, share, width));
    for (const ZoomPictures* pictures : {&bent, &synthesised})
        for (const double share : moments)
            rows.push_back(seen(picture(*pictures, share), pair, middle, share, width));
    rows.push_back(seen(pair.fine, pair, middle, 1, width));
    const int step = pair.coarse.rows + gap;
    cv::Mat sheet(static_cast<int>(rows.size()) * step - gap, width, CV_8UC3, cv::Scalar::all(0));
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].copyTo(sheet(cv::Rect(0, static_cast<int>(i) * step, width, pair.coarse.rows)));
    return sheet;
}

}  // namespace vitrine::analyzer
