#include "analyzer/saliency/take_parts.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace vitrine::analyzer {

namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr std::chrono::seconds max_unsplit{10};
constexpr double still_share = .003;        // of the picture: less is noise
constexpr int changed_levels = 20;          // of 255, between two samples
constexpr milliseconds before_action{800};  // that a part shows before something moves, and after it
constexpr milliseconds min_empty{2500};     // a shorter rest belongs to the action
constexpr milliseconds min_part{3000};      // of a part that is split where its place changes
constexpr double max_shared = .55;          // of the saliency of 3 s before and after a split

bool is_action(const Sample& sample) {
    return sample.changed_share > still_share || !sample.faces.empty();
}

/// The stretches in which something happens, those that nearly touch in one.
std::vector<TakePart> actions(std::span<const Sample> samples, nanoseconds begin, nanoseconds end) {
    std::vector<TakePart> parts;
    nanoseconds before = begin;
    for (const Sample& sample : samples) {
        const nanoseconds from = std::max(begin, before - before_action);
        before = sample.time;
        if (!is_action(sample)) continue;
        const nanoseconds until = std::min(end, sample.time + before_action);
        if (!parts.empty() && from - parts.back().end < min_empty)
            parts.back().end = until;
        else
            parts.push_back({from, until});
    }
    return parts;
}

/// The sum of what is salient from one time to another.
SaliencyMap sum_of(std::span<const Sample> samples, nanoseconds from, nanoseconds until) {
    SaliencyMap sum;
    for (const Sample& sample : samples) {
        if (sample.time < from || sample.time >= until) continue;
        for (const SaliencyMap* map : {&sample.motion, &sample.image}) {
            if (map->empty()) continue;
            if (sum.empty()) sum = SaliencyMap::zeros(map->size(), CV_32FC1);
            sum += *map;
        }
    }
    return sum;
}

/// The share of the saliency before a time that lies where the saliency after it does.
double shared_at(std::span<const Sample> samples, nanoseconds time) {
    const SaliencyMap before = sum_of(samples, time - min_part, time);
    const SaliencyMap after = sum_of(samples, time, time + min_part);
    if (before.empty() || after.empty()) return 1;
    const double most = std::max(cv::sum(before)[0], cv::sum(after)[0]);
    return most > 0 ? cv::sum(cv::min(before, after))[0] / most : 1;
}

std::optional<nanoseconds> place_to_split(std::span<const Sample> samples, const TakePart& part) {
    std::optional<nanoseconds> best;
    double least = max_shared;
    for (const Sample& sample : samples) {
        if (sample.time < part.begin + min_part || sample.time > part.end - min_part) continue;
        const double shared = shared_at(samples, sample.time);
        if (shared >= least) continue;
        least = shared;
        best = sample.time;
    }
    return best;
}

void add_split(std::span<const Sample> samples, const TakePart& part, std::vector<TakePart>& out) {
    const bool is_long = part.end - part.begin > max_unsplit;
    const auto at = is_long ? place_to_split(samples, part) : std::nullopt;
    if (!at) return out.push_back(part);
    add_split(samples, {part.begin, *at}, out);
    add_split(samples, {*at, part.end}, out);
}

}  // namespace

double changed_share(const cv::Mat& before, const cv::Mat& now) {
    const cv::Size size = map_size(now.size());
    cv::Mat a;
    cv::Mat b;
    cv::resize(before, a, size, 0, 0, cv::INTER_AREA);
    cv::resize(now, b, size, 0, 0, cv::INTER_AREA);
    cv::Mat difference;
    cv::absdiff(a, b, difference);
    cv::cvtColor(difference, difference, cv::COLOR_BGR2GRAY);
    return static_cast<double>(cv::countNonZero(difference > changed_levels)) /
           static_cast<double>(difference.total());
}

std::vector<TakePart> take_parts(std::span<const Sample> samples, nanoseconds begin, nanoseconds end) {
    if (end - begin <= max_unsplit) return {{begin, end}};
    std::vector<TakePart> shown = actions(samples, begin, end);
    if (shown.empty()) return {{begin, end}};
    if (shown.front().begin - begin < min_empty) shown.front().begin = begin;
    if (end - shown.back().end < min_empty) shown.back().end = end;
    std::vector<TakePart> parts;
    nanoseconds at = begin;
    for (const TakePart& part : shown) {
        if (at < part.begin) parts.push_back({at, part.begin, true});
        add_split(samples, part, parts);
        at = part.end;
    }
    if (at < end) parts.push_back({at, end, true});
    return parts;
}

}  // namespace vitrine::analyzer
