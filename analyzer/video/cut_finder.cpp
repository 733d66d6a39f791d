#include "analyzer/video/cut_finder.hpp"

#include <functional>
#include <vector>

namespace vitrine {

namespace {

constexpr double least_step = .06;          // colour difference of any cut
constexpr double clear_step = .12;          // of most
constexpr double above_third = 2;           // times the third largest step around
constexpr double above_third_if_small = 6;  // the same of a step below clear_step: in a still, dark scene
constexpr double above_median = 3;          // times the median step around
constexpr double lasting_difference = .09;  // colour difference of what lies on both sides
constexpr double lasting_change = 8;        // grey levels
constexpr std::chrono::milliseconds flash{120};
constexpr std::size_t flash_frames = 3;  // at least

bool is_around(const FeatureWindow& window, std::size_t frame, std::size_t other) {
    const std::size_t frames = other > frame ? other - frame : frame - other;
    const auto distance = std::chrono::abs(window.time(other) - window.time(frame));
    return frames <= cut_radius_frames || distance <= cut_radius;
}

// What `step_of` says of the frames around one, without its own, the largest first.
template <typename Step>
std::vector<double> steps_around(const FeatureWindow& window, std::size_t frame, const Step& step_of) {
    std::vector<double> steps;
    for (std::size_t i = frame; i > window.first() + 1 && is_around(window, frame, i - 1); --i)
        steps.push_back(step_of(i - 1));
    for (std::size_t i = frame + 1; i < window.end() && is_around(window, frame, i); ++i)
        steps.push_back(step_of(i));
    std::ranges::sort(steps, std::greater<>());
    return steps;
}

// A flash brings two steps more, hence the third largest.
double third(const std::vector<double>& steps) {
    return steps.size() > 2 ? steps[2] : 0;
}

bool stands_out(const FeatureWindow& window, std::size_t frame) {
    const double step = window.step_at(frame);
    if (step <= least_step) return false;
    const auto steps = steps_around(window, frame, [&](std::size_t i) { return window.step_at(i); });
    if (steps.empty()) return true;
    return step >= steps.front() &&
           step > (step > clear_step ? above_third : above_third_if_small) * third(steps) &&
           step > above_median * steps[steps.size() / 2];
}

// Colours alone jump as well where a large even area crosses from one bin to the next: the picture must jump
// too.
bool jumps(const FeatureWindow& window, std::size_t frame) {
    const auto change = [&](std::size_t i) { return picture_difference(window.at(i - 1), window.at(i)); };
    const double here = change(frame);
    return here > lasting_change && here > above_third * third(steps_around(window, frame, change));
}

// How many frames a flash may last here.
std::size_t flash_length(const FeatureWindow& window, std::size_t frame) {
    std::size_t count = flash_frames;
    while (frame + count + 1 < window.end() && window.time(frame + count) - window.time(frame) < flash)
        ++count;
    return count;
}

bool lasts(const FeatureWindow& window, std::size_t frame) {
    const std::size_t length = flash_length(window, frame);
    const auto& before = window.at(frame - 1);
    const auto& long_before = window.at(window.before(frame, length + 1));
    const auto& here = window.at(frame);
    const auto& long_after = window.at(window.after(frame, length));
    return colour_difference(before, long_after) > lasting_difference &&
           colour_difference(long_before, here) > lasting_difference &&
           colour_difference(long_before, long_after) > lasting_difference;
}

}  // namespace

bool is_cut(const FeatureWindow& window, std::size_t frame) {
    if (frame <= window.first() || frame >= window.end()) return false;
    return stands_out(window, frame) && lasts(window, frame) && jumps(window, frame);
}

}  // namespace vitrine
