#include "analyzer/saliency/drift.hpp"

#include "analyzer/saliency/drift_search.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace vitrine::analyzer {
namespace {

constexpr double half = 0.5;
constexpr double min_gain = 0.05;        // share of the area, for which the region starts to move
constexpr double max_loss = 0.02;        // share of the area that the subject's own motion may cost
constexpr double max_loss_panned = 0.5;  // share that the camera's may cost, for then nothing stands still
constexpr double carried = 0.25;     // share of the background's motion by which a carried subject differs
constexpr double unsteady = 0.2;     // share of the way: a motion that deviates more is no drift
constexpr double followable = 0.75;  // share of a measured drift that the common part must allow
constexpr double min_travel = 0.03;  // share of the diagonal over the shot: a slower region stands still

/// True where a drift is long enough over the shot to count.
bool is_travel(Vec2 drift, double duration, cv::Size frame) {
    return length(drift) * duration >= min_travel * std::hypot(frame.width, frame.height);
}

/// Slope of the least-squares line of points over time; 0 where all times are one.
double slope(std::span<const double> times, std::span<const double> values) {
    const auto n = static_cast<double>(times.size());
    const double mean_t = std::accumulate(times.begin(), times.end(), 0.0) / n;
    const double mean_v = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double above = 0;
    double below = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        above += (times[i] - mean_t) * (values[i] - mean_v);
        below += (times[i] - mean_t) * (times[i] - mean_t);
    }
    return below > 0 ? above / below : 0;
}

template <typename Centre> Vec2 line_through(std::span<const SalientFrame> frames, Centre centre) {
    std::vector<double> times;
    std::vector<double> xs;
    std::vector<double> ys;
    for (const SalientFrame& frame : frames) {
        const Vec2 c = centre(frame.map);
        times.push_back(frame.time);
        xs.push_back(c.x);
        ys.push_back(c.y);
    }
    return {slope(times, xs), slope(times, ys)};
}

/// The centroid of a map's squares: where the subject is, whatever the background does.
Vec2 peak_centroid(const SaliencyMap& map) {
    const cv::Moments m = cv::moments(map.mul(map));
    if (m.m00 <= 0) return {map.cols * half, map.rows * half};
    return {m.m10 / m.m00 + half, m.m01 / m.m00 + half};
}

/// A motion at constant speed, and the deviation of the measured path from it.
struct SteadyMotion {
    Vec2 slope;
    double deviation = 0;  // px, root mean square
};

/// The line through the path that measured velocities add up to.
SteadyMotion line_along(std::span<const SalientFrame> frames, Vec2 SalientFrame::*velocity) {
    std::vector<double> times;
    std::vector<double> xs;
    std::vector<double> ys;
    Vec2 at;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        // The first frame of a shot has none before it to be measured against.
        if (i > 0) at = at + frames[i].*velocity * (frames[i].time - frames[i - 1].time);
        times.push_back(frames[i].time);
        xs.push_back(at.x);
        ys.push_back(at.y);
    }
    const Vec2 v{slope(times, xs), slope(times, ys)};
    const auto n = static_cast<double>(frames.size());
    const Vec2 mean{std::accumulate(xs.begin(), xs.end(), 0.0) / n,
                    std::accumulate(ys.begin(), ys.end(), 0.0) / n};
    const double mean_time = std::accumulate(times.begin(), times.end(), 0.0) / n;
    double sum = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const Vec2 off = Vec2{xs[i], ys[i]} - mean - v * (times[i] - mean_time);
        sum += dot(off, off);
    }
    return {v, std::sqrt(sum / n)};
}

struct MeasuredDrift {
    Vec2 drift;
    double max_loss = 0;  // share of the area that it may cost
};

/// The drift by the flow: the background's motion where the subject moves with it, for many vectors measure
/// it, else the subject's; none where that is no steady motion.
MeasuredDrift measured_drift(std::span<const SalientFrame> frames, double duration) {
    const SteadyMotion background = line_along(frames, &SalientFrame::global_motion);
    const SteadyMotion subject = line_along(frames, &SalientFrame::subject_motion);
    const bool is_carried = length(subject.slope - background.slope) <= carried * length(background.slope);
    const SteadyMotion& line = is_carried ? background : subject;
    const double travel = length(line.slope) * duration;
    if (line.deviation > unsteady * travel) return {};
    return {line.slope, is_carried ? max_loss_panned : max_loss};
}

/// The drift, in search px, that concentrates most. A measured drift is used unless it spreads the saliency
/// or is too fast to follow; a drift that was only searched for must concentrate the saliency clearly.
Vec2 max_concentrating(const SearchSpace& space, const MeasuredDrift& measured) {
    const double still = space.area({});
    const cv::Size size = space.frames.front().map.size();
    const Vec2 followed = limited_drift(size, measured.drift, space.duration);
    const bool is_followed =
        is_travel(followed, space.duration, size) && length(followed) >= followable * length(measured.drift);
    if (is_followed && space.area(followed) <= still * (1 + measured.max_loss)) return followed;
    Vec2 best;
    double least = still * (1 - min_gain);
    for (const Vec2 drift : {followed, line_through(space.frames, peak_centroid), searched_drift(space)}) {
        const double area = space.area(drift);
        if (area >= least) continue;
        least = area * (1 - min_gain);
        best = limited_drift(size, drift, space.duration);
    }
    return best;
}

Vec2 smallest_area_drift(std::span<const SalientFrame> frames, double duration) {
    const SearchSpace space = search_space(frames, duration);
    MeasuredDrift measured = measured_drift(frames, duration);
    measured.drift = measured.drift * space.scale;
    const Vec2 drift = max_concentrating(space, measured) * (1 / space.scale);
    return is_travel(drift, duration, frames.front().map.size()) ? drift : Vec2{};
}

}  // namespace

Box half_mass_box(const SaliencyMap& map) {
    std::vector<float> values(map.begin<float>(), map.end<float>());
    std::sort(values.begin(), values.end(), std::greater<>());
    const double mass = half * cv::sum(map)[0];
    const Box whole{{0, 0}, {static_cast<double>(map.cols), static_cast<double>(map.rows)}};
    if (mass <= 0) return whole;
    double sum = 0;
    std::size_t count = 0;
    while (count < values.size() && sum < mass)
        sum += static_cast<double>(values[count++]);
    const cv::Rect r = cv::boundingRect(map >= static_cast<double>(values[count - 1]));
    return {{static_cast<double>(r.x), static_cast<double>(r.y)},
            {static_cast<double>(r.x + r.width), static_cast<double>(r.y + r.height)}};
}

Vec2 found_drift(std::span<const SalientFrame> frames, double duration, DriftMode mode) {
    if (frames.size() < 2 || duration <= 0 || mode == DriftMode::none) return {};
    if (mode == DriftMode::smallest_area) return smallest_area_drift(frames, duration);
    const auto box_centre = [](const SaliencyMap& map) { return half_mass_box(map).centre(); };
    return limited_drift(frames.front().map.size(), line_through(frames, box_centre), duration);
}

}  // namespace vitrine::analyzer
