#include "analyzer/film/cut_finder.hpp"

#include "analyzer/film/block_motion.hpp"

#include <functional>
#include <vector>

namespace vitrine::analyzer {

namespace {

using std::chrono::milliseconds;

constexpr double min_cut_step = 4;   // grey levels that the picture changes by at any cut
constexpr double above_third = 1.4;  // times the third largest step around: two may belong to a flash
constexpr double above_median = 3;   // times the median step around
constexpr milliseconds around{240};
constexpr std::size_t around_frames = 4;  // at least so many frames, where they are rare

constexpr double min_unexplained = .09;  // share at a cut
constexpr double above_next = 3;         // times the unexplained share close by
constexpr double above_busier = 2;       // times that of the busier side, if the other is calm
constexpr double large_area = .75;
constexpr double above_next_if_unlike = 1.2;
constexpr milliseconds close_by{80};
// Times the steps around, where little is unexplained: motion cannot explain a change of colours only.
constexpr double clear_step = 6;

// Bounds for an abrupt change to a picture that may be seen again soon, or that shows the same from
// elsewhere.
constexpr milliseconds max_blink{140};
constexpr milliseconds max_flash{250};
constexpr double flash_light = 20;        // grey levels by which a flash is brighter
constexpr double min_abrupt_share = .05;  // unexplained share
constexpr double min_abrupt_area = .5;
constexpr double abrupt = 6;    // times the unexplained share close by
constexpr double lasting = .5;  // share of the change at once that must stay

constexpr double noise = .006;  // share that is always unexplained

bool is_around(const FeatureWindow& window, std::size_t frame, std::size_t other) {
    const std::size_t frames = other > frame ? other - frame : frame - other;
    return frames <= around_frames || std::chrono::abs(window.time(other) - window.time(frame)) <= around;
}

// The prominence of a frame's step among the steps around it: 1 at the threshold.
double prominence(const FeatureWindow& window, std::size_t frame) {
    std::vector<double> steps;
    for (std::size_t i = frame; i > window.first() + 1 && is_around(window, frame, i - 1); --i)
        steps.push_back(window.step_at(i - 1));
    for (std::size_t i = frame + 1; i < window.end() && is_around(window, frame, i); ++i)
        steps.push_back(window.step_at(i));
    std::ranges::sort(steps, std::greater<>());
    const double third = steps.size() > 2 ? steps[2] : 0;
    const double median = steps.empty() ? 0 : steps[steps.size() / 2];
    return window.step_at(frame) / std::max({above_third * third, above_median * median, min_cut_step});
}

Unexplained unexplained_at(const FeatureWindow& window, std::size_t frame) {
    return unexplained(window.at(frame - 1), window.at(frame));
}

// The largest unexplained share between neighbouring frames close by, on either side.
struct Beside {
    double before = noise;
    double after = noise;
};

Beside beside(const FeatureWindow& window, std::size_t frame) {
    Beside most;
    for (std::size_t i = std::max(window.back(frame - 1, close_by), window.first()) + 1; i < frame; ++i)
        most.before = std::max(most.before, unexplained_at(window, i).share + noise);
    const std::size_t last = std::max(window.ahead(frame, close_by), window.ahead(frame, milliseconds{1}));
    for (std::size_t i = frame + 1; i <= last; ++i)
        most.after = std::max(most.after, unexplained_at(window, i).share + noise);
    return most;
}

// Says if so much stays unexplained for as long as a flash can last, before and after.
bool lasts(const FeatureWindow& window, std::size_t frame, double left) {
    const auto unlike = [&](std::size_t before, std::size_t after) {
        return unexplained(window.at(before), window.at(after)).share > lasting * left;
    };
    const auto time = window.time(frame);
    const double brighter = window.at(frame).mean - window.at(frame - 1).mean;
    const milliseconds after = brighter > flash_light ? max_flash : max_blink;
    const milliseconds before = brighter < -flash_light ? max_flash : max_blink;
    for (std::size_t i = frame + 1; i < window.end() && window.time(i) - time < after; ++i)
        if (!unlike(frame - 1, i)) return false;
    for (std::size_t i = frame - 1; i > window.first() && time - window.time(i) < before; --i)
        if (!unlike(i - 1, frame)) return false;
    return true;
}

}  // namespace

bool is_cut(const FeatureWindow& window, std::size_t frame) {
    if (frame <= window.first() || frame >= window.end() || window.step_at(frame) < min_cut_step)
        return false;
    const double stands_out = prominence(window, frame);
    if (stands_out < 1) return false;
    const Unexplained left = unexplained_at(window, frame);
    if (left.share < min_abrupt_share)
        return stands_out > clear_step && is_new_take(window, frame - 1, frame);
    const auto [before, after] = beside(window, frame);
    const double busier = std::max(before, after);
    const double calmer = std::min(before, after);
    const bool is_abrupt =
        left.share > abrupt * busier && left.share > min_abrupt_share && left.area > min_abrupt_area;
    if (is_abrupt && lasts(window, frame, left.share)) return true;
    if (left.share < min_unexplained) return stands_out > clear_step && is_new_take(window, frame - 1, frame);
    if (left.share < above_next_if_unlike * busier) return false;
    const TakeChange change = take_change(window, frame - 1, frame);
    if (change == TakeChange::clear) return true;
    const bool is_clear_here =
        left.share > above_next * busier ||
        (left.area > large_area && left.share > above_busier * busier && left.share > abrupt * calmer);
    return change == TakeChange::likely && is_clear_here && left.area > min_abrupt_area;
}

}  // namespace vitrine::analyzer
