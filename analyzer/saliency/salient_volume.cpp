#include "analyzer/saliency/salient_volume.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace vitrine {
namespace {

constexpr double half = 0.5;
constexpr double least_common_part = 0.6;  // of each side
constexpr double least_gain = 0.05;        // of the area, for which the region starts to move
constexpr double least_travel = 0.03;      // of the diagonal over the shot, below which it stands still
constexpr int search_side = 64;            // px, longest side of the maps searched on
constexpr std::size_t search_frames = 24;
constexpr int levels = 512;  // of the histogram the half mass is read from

Vec2 limited(Vec2 drift, cv::Size frame, double duration) {
    if (duration <= 0) return {};
    const double scale_x = (1 - least_common_part) * frame.width / (std::abs(drift.x) * duration + 1e-9);
    const double scale_y = (1 - least_common_part) * frame.height / (std::abs(drift.y) * duration + 1e-9);
    return drift * std::min({1.0, scale_x, scale_y});
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

/// What exceeds the map's median: the subject's part, for a background that lies everywhere concentrates
/// nowhere.
cv::Mat excess(const SaliencyMap& map) {
    std::vector<float> values(map.begin<float>(), map.end<float>());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return cv::max(map - static_cast<double>(*middle), 0);
}

/// The centroid of a map's squares: where the subject is, whatever the background does.
Vec2 peak_centroid(const SaliencyMap& map) {
    const cv::Moments m = cv::moments(map.mul(map));
    if (m.m00 <= 0) return {map.cols * half, map.rows * half};
    return {m.m10 / m.m00 + half, m.m01 / m.m00 + half};
}

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Vec2 median_global_motion(std::span<const SalientFrame> frames) {
    std::vector<double> xs;
    std::vector<double> ys;
    for (const SalientFrame& frame : frames) {
        xs.push_back(frame.global_motion.x);
        ys.push_back(frame.global_motion.y);
    }
    return {median_of(std::move(xs)), median_of(std::move(ys))};
}

/// How many of the largest values inside `part` reach `mass`; all of the map's where they do not.
int count_reaching(const cv::Mat& map, const cv::Rect& part, double mass) {
    double highest = 0;
    cv::minMaxLoc(map(part), nullptr, &highest);
    if (highest <= 0) return static_cast<int>(map.total());
    std::array<double, levels> sums{};
    std::array<int, levels> counts{};
    for (int y = part.y; y < part.y + part.height; ++y) {
        const auto* row = map.ptr<float>(y);
        for (int x = part.x; x < part.x + part.width; ++x) {
            const auto value = static_cast<double>(row[x]);
            const auto level = static_cast<std::size_t>(std::max(0.0, value / highest * (levels - 1)));
            sums[level] += value;
            ++counts[level];
        }
    }
    double sum = 0;
    int count = 0;
    for (std::size_t level = levels; level-- > 0;) {
        if (sum + sums[level] >= mass) {
            const double share = sums[level] > 0 ? (mass - sum) / sums[level] : 0;
            return count + static_cast<int>(std::ceil(share * counts[level]));
        }
        sum += sums[level];
        count += counts[level];
    }
    return static_cast<int>(map.total());
}

double total_mass(std::span<const SalientFrame> frames) {
    double mass = 0;
    for (const SalientFrame& frame : frames)
        mass += cv::sum(frame.map)[0];
    return mass;
}

cv::Rect whole_pixels(const Box& box, cv::Size size) {
    const int x0 = std::clamp(static_cast<int>(std::ceil(box.min.x - 1e-6)), 0, size.width);
    const int y0 = std::clamp(static_cast<int>(std::ceil(box.min.y - 1e-6)), 0, size.height);
    const int x1 = std::clamp(static_cast<int>(std::floor(box.max.x + 1e-6)), x0, size.width);
    const int y1 = std::clamp(static_cast<int>(std::floor(box.max.y + 1e-6)), y0, size.height);
    return {x0, y0, x1 - x0, y1 - y0};
}

/// Accumulation by whole pixels: enough to compare drifts, and many times faster.
cv::Mat coarsely_accumulated(std::span<const SalientFrame> frames, Vec2 drift) {
    cv::Mat sum = cv::Mat::zeros(frames.front().map.size(), CV_32FC1);
    const cv::Rect all({}, sum.size());
    for (const SalientFrame& frame : frames) {
        const cv::Point shift(static_cast<int>(std::lround(drift.x * frame.time)),
                              static_cast<int>(std::lround(drift.y * frame.time)));
        const cv::Rect to = all & (all - shift);
        if (!to.empty()) sum(to) += frame.map(to + shift);
    }
    return sum;
}

double area_of(const cv::Mat& volume, const Box& common, double mass) {
    const cv::Rect part = whole_pixels(common, volume.size());
    if (part.empty()) return 1;
    return count_reaching(volume, part, half * mass) / static_cast<double>(volume.total());
}

/// The frames thinned and made smaller for the search, in their own pixels.
struct SearchSpace {
    std::vector<SalientFrame> frames;
    double duration = 0;
    double mass = 0;
    double scale = 1;  // search px per map px

    double area(Vec2 drift) const {
        const Vec2 allowed = limited(drift, frames.front().map.size(), duration);
        return area_of(coarsely_accumulated(frames, allowed),
                       common_part(frames.front().map.size(), allowed, duration), mass);
    }
};

SearchSpace search_space(std::span<const SalientFrame> frames, double duration) {
    SearchSpace space{.frames = {}, .duration = duration};
    const cv::Size size = frames.front().map.size();
    space.scale = std::min(1.0, static_cast<double>(search_side) / std::max(size.width, size.height));
    const std::size_t count = std::min(frames.size(), search_frames);
    for (std::size_t i = 0; i < count; ++i) {
        const SalientFrame& frame = frames[i * frames.size() / count];
        SalientFrame small{.map = {}, .time = frame.time, .global_motion = frame.global_motion * space.scale};
        cv::resize(frame.map, small.map, {}, space.scale, space.scale, cv::INTER_AREA);
        small.map = excess(small.map);
        space.frames.push_back(std::move(small));
    }
    space.mass = total_mass(space.frames);
    return space;
}

/// The best of columns x rows drifts around `centre`, `reach` to either side.
Vec2 best_on_grid(const SearchSpace& space, Vec2 centre, Vec2 reach, int columns, int rows) {
    Vec2 best = centre;
    double least = space.area(centre);
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const Vec2 drift{centre.x + reach.x * (2.0 * i / (columns - 1) - 1),
                             centre.y + reach.y * (2.0 * j / (rows - 1) - 1)};
            const double area = space.area(drift);
            if (area >= least) continue;
            least = area;
            best = drift;
        }
    }
    return best;
}

/// Over all drifts that leave enough in common, then finer around the best.
Vec2 searched_drift(const SearchSpace& space) {
    const cv::Size size = space.frames.front().map.size();
    const Vec2 reach{(1 - least_common_part) * size.width / space.duration,
                     (1 - least_common_part) * size.height / space.duration};
    const Vec2 coarse = best_on_grid(space, {}, reach, 13, 9);
    return best_on_grid(space, coarse, {reach.x / 6, reach.y / 4}, 7, 7);
}

Vec2 most_concentrating(std::span<const SalientFrame> frames, double duration) {
    const SearchSpace space = search_space(frames, duration);
    const double still = space.area({});
    Vec2 best;
    double least = still * (1 - least_gain);
    for (const Vec2 drift : {line_through(space.frames, peak_centroid), median_global_motion(space.frames),
                             searched_drift(space)}) {
        const double area = space.area(drift);
        if (area >= least) continue;
        least = area;
        best = drift;
    }
    const cv::Size size = frames.front().map.size();
    const Vec2 drift = limited(best * (1 / space.scale), size, duration);
    const bool is_worth_it = length(drift) * duration >= least_travel * std::hypot(size.width, size.height);
    return is_worth_it ? drift : Vec2{};
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

SaliencyMap accumulated(std::span<const SalientFrame> frames, Vec2 drift) {
    SaliencyMap sum = SaliencyMap::zeros(frames.front().map.size(), CV_32FC1);
    cv::Mat moved;
    for (const SalientFrame& frame : frames) {
        const Vec2 shift = drift * frame.time;
        if (shift == Vec2{}) {
            sum += frame.map;
            continue;
        }
        const cv::Matx23d place(1, 0, shift.x, 0, 1, shift.y);
        cv::warpAffine(frame.map, moved, place, sum.size(), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                       cv::BORDER_CONSTANT, 0);
        sum += moved;
    }
    return sum;
}

Box common_part(cv::Size frame, Vec2 drift, double duration) {
    const Vec2 travel = drift * duration;
    return {{std::max(0.0, -travel.x), std::max(0.0, -travel.y)},
            {frame.width - std::max(0.0, travel.x), frame.height - std::max(0.0, travel.y)}};
}

Vec2 found_drift(std::span<const SalientFrame> frames, double duration, DriftMode mode) {
    if (frames.size() < 2 || duration <= 0 || mode == DriftMode::none) return {};
    if (mode == DriftMode::smallest_area) return most_concentrating(frames, duration);
    const auto box_centre = [](const SaliencyMap& map) { return half_mass_box(map).centre(); };
    return limited(line_through(frames, box_centre), frames.front().map.size(), duration);
}

}  // namespace vitrine
