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
constexpr double near_plane = .1;    // share of the wipe's duration: an edge may be soft
constexpr double min_on_plane = .9;  // share of the places that changed
constexpr double clearly_on_plane = .97;
constexpr int refits = 4;
constexpr double min_unmoved = .12;  // share of the change that is no pan past an edge
constexpr milliseconds min_wipe{70};
constexpr milliseconds margin{80};  // a soft edge reaches so much further

constexpr int width = static_cast<int>(FrameFeatures::signature_width);
constexpr int height = static_cast<int>(FrameFeatures::signature_height);

}  // namespace

struct WipeFinder::Passing {
    double x = 0;  // in [-.5, .5]
    double y = 0;
    double time = 0;    // s after the window's begin
    double change = 0;  // grey levels, capped
    double weight = 0;  // the change; 0 off the plane
};

// The sum over the channels of each place's change, grey levels.
WipeFinder::Changes WipeFinder::changes(const FrameFeatures& before, const FrameFeatures& after) {
    std::array<std::uint8_t, 3 * places> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = static_cast<std::uint8_t>(std::max(before.signature[i], after.signature[i]) -
                                           std::min(before.signature[i], after.signature[i]));
    Changes out{};
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = static_cast<std::uint16_t>(all[3 * i] + all[3 * i + 1] + all[3 * i + 2]);
    return out;
}

void WipeFinder::remember(const FeatureWindow& window, std::size_t frame) {
    if (frame != end_) changes_.clear();  // a gap longer than the window
    Changes now{};
    if (frame > window.first()) {
        const FrameFeatures& before = window.at(frame - 1);
        const Changes over_two = changes(before, window.at(std::min(frame + 1, window.end() - 1)));
        now = changes(before, window.at(frame));
        for (std::size_t i = 0; i < now.size(); ++i)
            now[i] = std::min({now[i], over_two[i], over_two_[i]});
        over_two_ = over_two;
    }
    changes_.push_back(now);
    end_ = frame + 1;
    while (end_ - changes_.size() < window.back(frame, lengths.back()))
        changes_.pop_front();
}

// The time at which each place changes most; places that hardly change are left out.
std::vector<WipeFinder::Passing> WipeFinder::passings(const FeatureWindow& window, std::size_t first,
                                                      std::size_t last) const {
    Changes most{};
    Changes when{};
    const std::size_t oldest = end_ - changes_.size();
    for (std::size_t frame = std::max(first + 1, oldest); frame <= last; ++frame) {
        const Changes& now = changes_[frame - oldest];
        const auto number = static_cast<std::uint16_t>(frame - first);
        for (std::size_t i = 0; i < places; ++i) {
            when[i] = now[i] > most[i] ? number : when[i];
            most[i] = std::max(most[i], now[i]);
        }
    }
    std::vector<Passing> out;
    for (std::size_t i = 0; i < places; ++i) {
        if (most[i] < 3 * min_change) continue;
        const std::size_t row = i / FrameFeatures::signature_width;
        const double x = static_cast<double>(i % FrameFeatures::signature_width) + .5;
        const double y = static_cast<double>(row) + .5;
        const Seconds time = window.time(first + when[i]) - window.time(first);
        const double change = std::min(most[i] / 3.0, max_change);
        out.push_back({.x = x / FrameFeatures::signature_width - .5,
                       .y = y / FrameFeatures::signature_height - .5,
                       .time = time.count(),
                       .change = change,
                       .weight = change});
    }
    return out;
}

namespace {

struct Plane {
    double x = 0;  // s over the picture's width
    double y = 0;
    double middle = 0;

    template <typename Passing> double at(const Passing& place) const {
        return middle + x * place.x + y * place.y;
    }

    double duration() const { return std::abs(x) + std::abs(y); }
};

// Fits a plane by weighted least squares.
template <typename Passing> std::optional<Plane> fitted(const std::vector<Passing>& places) {
    cv::Matx33d normal = cv::Matx33d::zeros();
    cv::Vec3d right(0, 0, 0);
    for (const Passing& place : places) {
        const cv::Vec3d row(place.x, place.y, 1);
        normal += place.weight * row * row.t();
        right += place.weight * place.time * row;
    }
    cv::Vec3d solved;
    if (!cv::solve(normal, right, solved, cv::DECOMP_CHOLESKY)) return std::nullopt;
    return Plane{solved[0], solved[1], solved[2]};
}

// The plane that most places lie on, and their share.
template <typename Passing> std::optional<Plane> edge_of(std::vector<Passing>& places) {
    const double changing = static_cast<double>(places.size()) / (width * height);
    if (changing < min_changing_if_clear) return std::nullopt;
    std::optional<Plane> plane;
    double reach = 1e9;
    for (int i = 0; i < refits; ++i) {
        plane = fitted(places);
        if (!plane) return std::nullopt;
        reach = std::max(near_plane * plane->duration(), .02) * (refits - i);
        for (Passing& place : places)
            place.weight = std::abs(place.time - plane->at(place)) < reach ? place.change : 0;
    }
    double on_plane = 0;
    double all = 0;
    for (const Passing& place : places) {
        on_plane += place.weight;
        all += place.change;
    }
    if (on_plane < (changing < min_changing ? clearly_on_plane : min_on_plane) * all) return std::nullopt;
    return plane;
}

}  // namespace

std::optional<Transition> WipeFinder::wipe_in(const FeatureWindow& window, std::size_t first,
                                              std::size_t last) const {
    if (last < first + min_wipe_frames || picture_difference(window.at(first), window.at(last)) < min_change)
        return std::nullopt;
    std::vector<Passing> found = passings(window, first, last);
    const auto plane = edge_of(found);
    if (!plane || plane->duration() < Seconds(min_wipe).count()) return std::nullopt;
    const auto at = [&](double seconds) {
        return window.time(first) + std::chrono::duration_cast<std::chrono::nanoseconds>(Seconds(seconds));
    };
    const auto begin = at(plane->middle - plane->duration() / 2);
    const auto end = at(plane->middle + plane->duration() / 2);
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
    remember(window, frame);
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
