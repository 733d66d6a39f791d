#pragma once

#include <opencv2/core.hpp>

#include <chrono>
#include <functional>
#include <vector>

namespace vitrine::study {

/// One level of an interface as the screen draws it.
struct SearchedLevel {
    cv::Mat picture;  // BGR, the whole film from left to right; empty: nothing of the film is drawn
    cv::Size frame;   // px of one whole frame in the picture
    std::function<std::chrono::nanoseconds(cv::Point)> moment_at;  // the film shows it after a click there
    std::function<int(std::chrono::nanoseconds)> x_at;             // px of the picture
};

/// An interface that leads to a moment of a film.
struct SearchedInterface {
    std::vector<SearchedLevel> levels;  // coarsest first; at least one
    int screen_width = 0;               // px of a level that are in view at once
    std::chrono::nanoseconds duration{0};
};

/// A scene that is sought.
struct SoughtScene {
    cv::Mat frame;  // BGR, the searcher has seen it
    std::chrono::nanoseconds shot_begin{0};
    std::chrono::nanoseconds shot_end{0};
};

constexpr int max_steps = 200;  // the searcher gives up

/// Searches a scene as a person would who knows one picture of it, by the same rules in every interface. The
/// film above stands at its begin. A drag by at most one screen, a zoom by one level and a click are a step
/// each. One look is what the screen shows.
///
/// The searcher compares the sought frame with all places in view. It clicks on the most alike one where it
/// stands out: where it differs by at most .8 of what the places in view differ in the median. Else it goes
/// on to what it has not seen of the coarsest level, from left to right; of a finer level, to the place that
/// was most alike on the coarser one. Where it has seen a level, it zooms in at the most alike place. Where
/// there is nothing left to see, it clicks into the middle of the longest stretch without a click.
///
/// @return the steps until the film shows the shot, or max_steps
int count_steps(const SearchedInterface& interface, const SoughtScene& scene);

/// The difference of the frame from the picture, by the place of the frame's middle, grey levels (root of the
/// mean square, 60 at most). The frame is compared in 5 x 3 parts, and each may lie half its size aside.
/// @return CV_32F, as large as the picture
cv::Mat differences(const cv::Mat& picture, const cv::Mat& frame);

}  // namespace vitrine::study
