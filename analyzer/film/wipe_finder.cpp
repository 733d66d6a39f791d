#include "analyzer/film/wipe_finder.hpp"

#include "analyzer/film/block_motion.hpp"
#include "analyzer/film/take_change.hpp"

#include <opencv2/core.hpp>

#include <cmath>
#include <vector>

namespace vitrine::analyzer {

namespace {

using std::chrono::milliseconds;
using Seconds = std::chrono::duration<double>;

constexpr std::array lengths{milliseconds{320}, milliseconds{700}, milliseconds{1400}, milliseconds{2600}};
constexpr int looks_a_length = 4;           // a wipe of 3/4 of a length lies wholly in one window
constexpr std::size_t min_wipe_frames = 4;  // frames of a wipe
constexpr double min_change = 12;           // grey levels that a place changes by when the edge passes
constexpr double max_change = 60;           // grey levels: more tells nothing more
constexpr double min_changing = .45;        // share of the picture in which the edge is seen to pass
constexpr double min_changing_if_clear = .2;
constexpr double near_plane = .1;      // share of the wipe's duration: an edge may be soft
constexpr double near_frames = .6;     // frames: times are known by frames
constexpr double min_on_line = .94;    // share of the places that changed
constexpr double min_on_circle = .85;  // a circle's edge is mostly soft
constexpr double clearly_on_edge = .97;
constexpr int refits = 4;
constexpr double min_unmoved = .12;  // share of the change that is no pan past an edge
constexpr milliseconds min_wipe{70};
constexpr milliseconds margin{80};  // a soft edge reaches so much further

}  // namespace

struct WipeFinder::Passing {
    double x = 0;  // in [-.5, .5]
    double y = 0;
    double radius = 0;  // share of the half diagonal
    double time = 0;    // s after the window's begin
    double change = 0;  // grey levels, capped
    double weight = 0;  // the change; 0 off the plane
};

namespace {

constexpr std::size_t places = FrameFeatures::signature_width * FrameFeatures::signature_height;
using Values = std::array<float, 3 * places>;

// For each place the frame from which on it looks otherwise: the place's colours, split there, differ most
// between both parts and least within them. Things that move in either shot, and flashes, do little to it.
struct Splits {
    std::array<float, places> most{};  // variance between both parts, times the number of frames
    std::array<float, places> when{};  // frames after the first
};

Values sum_of(const FeatureWindow& window, std::size_t first, std::size_t last) {
    Values sum{};
    for (std::size_t frame = first; frame <= last; ++frame) {
        const auto& signature = window.at(frame).signature;
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += static_cast<float>(signature[i]);
    }
    return sum;
}

Splits splits(const FeatureWindow& window, std::size_t first, std::size_t last) {
    const Values whole = sum_of(window, first, last);
    const auto count = static_cast<float>(last - first + 1);
    Splits result;
    Values sum{};
    Values squares{};
    for (std::size_t frame = first; frame < last; ++frame) {
        const auto& signature = window.at(frame).signature;
        const auto before = static_cast<float>(frame - first + 1);
        const float share = before / count;
        const float weight = 1 / (before * (1 - share));
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += static_cast<float>(signature[i]);
            const float beyond = sum[i] - share * whole[i];
            squares[i] = beyond * beyond;
        }
        for (std::size_t i = 0; i < places; ++i) {
            const float between = weight * (squares[3 * i] + squares[3 * i + 1] + squares[3 * i + 2]);
            result.when[i] = between > result.most[i] ? before : result.when[i];
            result.most[i] = std::max(result.most[i], between);
        }
    }
    return result;
}

}  // namespace

// The time at which each place changes for good; places that hardly change are left out.
std::vector<WipeFinder::Passing> WipeFinder::passings(const FeatureWindow& window, std::size_t first,
                                                      std::size_t last) {
    const Splits found = splits(window, first, last);
    const auto count = static_cast<double>(last - first + 1);
    std::vector<Passing> out;
    const double aspect = window.at(last).aspect;
    const double corner = std::hypot(aspect, 1) / 2;
    for (std::size_t i = 0; i < places; ++i) {
        const double before = found.when[i];
        if (before == 0) continue;
        const double change = std::sqrt(found.most[i] * count / (before * (count - before)) / 3);
        if (change < min_change) continue;
        const std::size_t row = i / FrameFeatures::signature_width;
        const auto column = static_cast<double>(i % FrameFeatures::signature_width);
        const double x = (column + .5) / FrameFeatures::signature_width - .5;
        const double y = (static_cast<double>(row) + .5) / FrameFeatures::signature_height - .5;
        const Seconds time =
            window.time(first + static_cast<std::size_t>(found.when[i])) - window.time(first);
        out.push_back({.x = x,
                       .y = y,
                       .radius = std::hypot(x * aspect, y) / corner,
                       .time = time.count(),
                       .change = std::min(change, max_change),
                       .weight = std::min(change, max_change)});
    }
    return out;
}

namespace {

// The times at which an edge passes the places: t = x a + y b + radius c + middle.
struct Edge {
    cv::Vec4d slopes{};   // s over the picture's width, its height and its half diagonal; s
    double duration = 0;  // s
    double begin = 0;     // s

    template <typename Passing> double at(const Passing& place) const {
        return slopes[0] * place.x + slopes[1] * place.y + slopes[2] * place.radius + slopes[3];
    }
};

enum class Shape { line, circle };

// Fits an edge by weighted least squares.
template <typename Passing> std::optional<Edge> fitted(const std::vector<Passing>& places, Shape shape) {
    cv::Matx33d normal = cv::Matx33d::zeros();
    cv::Vec3d right(0, 0, 0);
    for (const Passing& place : places) {
        const cv::Vec3d row =
            shape == Shape::line ? cv::Vec3d(place.x, place.y, 1) : cv::Vec3d(place.radius, 0, 1);
        normal += place.weight * row * row.t();
        right += place.weight * place.time * row;
    }
    if (shape == Shape::circle) normal(1, 1) = 1;
    cv::Vec3d s;
    if (!cv::solve(normal, right, s, cv::DECOMP_CHOLESKY)) return std::nullopt;
    if (shape == Shape::circle) return Edge{{0, 0, s[0], s[2]}, std::abs(s[0]), std::min(s[2], s[2] + s[0])};
    const double duration = std::abs(s[0]) + std::abs(s[1]);
    return Edge{{s[0], s[1], 0, s[2]}, duration, s[2] - duration / 2};
}

// The measures of the picture that decide how far a place may lie from an edge.
struct Seen {
    double changing = 0;  // share of the picture
    double frame = 0;     // s from one frame to the next
};

// The edge that most places lie on.
template <typename Passing>
std::optional<Edge> edge_of(std::vector<Passing> places, Shape shape, const Seen& seen) {
    std::optional<Edge> edge;
    for (int i = 0; i < refits; ++i) {
        edge = fitted(places, shape);
        if (!edge) return std::nullopt;
        const double reach =
            std::max(near_plane * edge->duration, std::max(.02, near_frames * seen.frame)) * (refits - i);
        for (Passing& place : places)
            place.weight = std::abs(place.time - edge->at(place)) < reach ? place.change : 0;
    }
    double on_edge = 0;
    double all = 0;
    for (const Passing& place : places) {
        on_edge += place.weight;
        all += place.change;
    }
    const double wanted = seen.changing < min_changing ? clearly_on_edge
                          : shape == Shape::line       ? min_on_line
                                                       : min_on_circle;
    if (on_edge < wanted * all || edge->duration < Seconds(min_wipe).count()) return std::nullopt;
    return edge;
}

}  // namespace

std::optional<Transition> WipeFinder::wipe_in(const FeatureWindow& window, std::size_t first,
                                              std::size_t last) {
    if (last < first + min_wipe_frames || picture_difference(window.at(first), window.at(last)) < min_change)
        return std::nullopt;
    const std::vector<Passing> found = passings(window, first, last);
    const double places_seen = common_part(window.at(first), window.at(last)).area();
    const Seen seen{.changing = static_cast<double>(found.size()) / places_seen,
                    .frame = Seconds(window.time(last) - window.time(first)).count() /
                             static_cast<double>(last - first)};
    if (seen.changing < min_changing_if_clear) return std::nullopt;
    std::optional<Transition> wipe;
    for (const Shape shape : {Shape::line, Shape::circle}) {
        const auto edge = wipe ? std::nullopt : edge_of(found, shape, seen);
        if (edge) wipe = passed(window, first, last, edge->begin, edge->duration);
    }
    return wipe;
}

// The wipe of an edge that passes from `begin` on, if it leaves another take behind.
std::optional<Transition> WipeFinder::passed(const FeatureWindow& window, std::size_t first, std::size_t last,
                                             double since, double duration) {
    const auto at = [&](double seconds) {
        return window.time(first) + std::chrono::duration_cast<std::chrono::nanoseconds>(Seconds(seconds));
    };
    const auto begin = at(since);
    const auto end = at(since + duration);
    if (begin < window.time(first) || end > window.time(last)) return std::nullopt;
    std::size_t from = first;
    while (from < last && window.time(from) + margin < begin)
        ++from;
    std::size_t to = from;
    while (to < last && window.time(to) < end + margin / 2)
        ++to;
    if (to < from + min_wipe_frames || !is_new_take(window, from, to) ||
        gradual_change(window, from, to).unmoved < min_unmoved)
        return std::nullopt;
    return Transition{window.time(from), window.time(to), ShotEnd::dissolve};
}

std::optional<Transition> WipeFinder::push(const FeatureWindow& window, std::size_t frame,
                                           std::size_t since) {
    std::optional<Transition> found;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        if (window.time(frame) < due_[i]) continue;
        due_[i] = window.time(frame) + lengths[i] / looks_a_length;
        const std::size_t first = std::max(window.back(frame, lengths[i]), since);
        if (!found) found = wipe_in(window, first, frame);
    }
    return found;
}

}  // namespace vitrine::analyzer
