#include "analyzer/saliency/drift_search.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vitrine::analyzer {
namespace {

constexpr double half = 0.5;
constexpr int search_side = 64;  // px, longest side of the maps searched on
constexpr std::size_t search_frames = 24;
constexpr int levels = 512;         // levels of the histogram that gives the half mass
constexpr double max_travel = 0.4;  // share of each side that a drift may travel

/// The map less its median: the subject's part, for a background that lies everywhere concentrates nowhere.
cv::Mat excess(const SaliencyMap& map) {
    std::vector<float> values(map.begin<float>(), map.end<float>());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return cv::max(map - static_cast<double>(*middle), 0);
}

/// The number of largest values inside `part` whose sum reaches `mass`; all of the map's where it does not.
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

}  // namespace

double SearchSpace::area(Vec2 drift) const {
    const Vec2 allowed = limited_drift(frames.front().map.size(), drift, duration);
    return area_of(coarsely_accumulated(frames, allowed),
                   common_part(frames.front().map.size(), allowed, duration), mass);
}

SearchSpace search_space(std::span<const SalientFrame> frames, double duration) {
    SearchSpace space{.frames = {}, .duration = duration};
    const cv::Size size = frames.front().map.size();
    space.scale = std::min(1.0, static_cast<double>(search_side) / std::max(size.width, size.height));
    const std::size_t count = std::min(frames.size(), search_frames);
    for (std::size_t i = 0; i < count; ++i) {
        const SalientFrame& frame = frames[i * frames.size() / count];
        SalientFrame small{.map = {}, .time = frame.time, .global_motion = frame.global_motion * space.scale};
        cv::resize(frame.map, small.map, scaled_size(frame.map.size(), space.scale), 0, 0, cv::INTER_AREA);
        small.map = excess(small.map);
        space.frames.push_back(std::move(small));
    }
    space.mass = total_mass(space.frames);
    return space;
}

Vec2 searched_drift(const SearchSpace& space) {
    const cv::Size size = space.frames.front().map.size();
    const Vec2 furthest{max_travel * size.width / space.duration, max_travel * size.height / space.duration};
    const Vec2 coarse = best_on_grid(space, {}, furthest, 13, 9);
    return best_on_grid(space, coarse, {furthest.x / 6, furthest.y / 4}, 7, 7);
}

}  // namespace vitrine::analyzer
