#include "analyzer/film/dissolve_finder.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace vitrine::analyzer {

namespace {

using std::chrono::milliseconds;

constexpr std::array windows{milliseconds{160}, milliseconds{240}, milliseconds{320}, milliseconds{480},
                             milliseconds{640}, milliseconds{960}, milliseconds{1280}};
constexpr std::size_t min_window_frames = 4;   // frames of a window
constexpr std::size_t max_looked_at = 32;      // frames of a window that are looked at
constexpr double min_energy = 150;             // mean square of D, grey levels squared
constexpr double alike = .6;                   // NCC of both ends from which on they are alike
constexpr double min_colour_difference = .15;  // colour difference of both ends
constexpr double uneven = .18;                 // largest deviation from even growth
constexpr double max_residue = .05;            // energy beside D, share of D's
constexpr double even = .1;                    // deviation so small that only a dissolve has it
constexpr double max_residue_if_even = .17;
constexpr milliseconds min_length_if_even{320};
constexpr double unlike = .2;  // NCC of ends that no motion explains: both shots may move then
constexpr double max_residue_if_unlike = .10;
// Dissolves of so few steps that they look like cuts: outside of them hardly anything may change.
constexpr std::array short_steps{std::size_t{3}, std::size_t{4}};
constexpr milliseconds max_short{300};
constexpr double max_step_outside = .6;  // share of a step inside
constexpr double uneven_if_short = .12;
constexpr double max_residue_if_short = .03;
constexpr milliseconds quiet{320};  // a dissolve is over after so long without a window

// Bars that move in from above and below are no dissolve: their rows do not count.
constexpr std::size_t row = 3 * FrameFeatures::signature_width;
constexpr std::size_t first_place = 3 * row;
constexpr std::size_t end_place = (FrameFeatures::signature_height - 3) * row;
constexpr double places = end_place - first_place;

double mean_product(const FrameFeatures& a, const FrameFeatures& b) {
    std::uint32_t sum = 0;
    for (std::size_t i = first_place; i < end_place; ++i)
        sum += std::uint32_t{a.signature[i]} * b.signature[i];
    return sum / places;
}

double mean_of(const FrameFeatures& a) {
    std::uint32_t sum = 0;
    for (std::size_t i = first_place; i < end_place; ++i)
        sum += a.signature[i];
    return sum / places;
}

double correlation(const FrameFeatures& a, const FrameFeatures& b) {
    const double ma = mean_of(a);
    const double mb = mean_of(b);
    const double spread = std::sqrt((mean_product(a, a) - ma * ma) * (mean_product(b, b) - mb * mb));
    return spread > 1 ? (mean_product(a, b) - ma * mb) / spread : 0;
}

// The share and residue of one frame on the line from s to e, by products of signatures only:
// with g = f_t - f_s: a = <g, D> / <D, D>, residue = (<g, g> - a^2 <D, D>) / <D, D>.
struct Line {
    double share = 0;
    double residue = 0;
};

class Ends {
  public:
    Ends(const FrameFeatures& start, const FrameFeatures& end)
        : start_(start),
          end_(end),
          start_start_(mean_product(start, start)),
          start_end_(mean_product(start, end)),
          energy_(start_start_ - 2 * start_end_ + mean_product(end, end)) {}

    double energy() const { return energy_; }

    Line line(const FrameFeatures& frame) const {
        const double frame_start = mean_product(frame, start_);
        const double along = mean_product(frame, end_) - frame_start - start_end_ + start_start_;
        const double squared = mean_product(frame, frame) - 2 * frame_start + start_start_;
        const double share = along / energy_;
        return {.share = share, .residue = squared / energy_ - share * share};
    }

  private:
    const FrameFeatures& start_;
    const FrameFeatures& end_;
    double start_start_;
    double start_end_;
    double energy_;
};

bool is_dissolve(const FeatureWindow& window, std::size_t first, std::size_t last, bool is_short) {
    const FrameFeatures& start = window.at(first);
    const FrameFeatures& end = window.at(last);
    const double likeness = correlation(start, end);
    if (likeness >= alike) return false;
    const Ends ends(start, end);
    if (ends.energy() <= min_energy || colour_difference(start, end) <= min_colour_difference) return false;
    const std::size_t step = std::max<std::size_t>(1, (last - first) / max_looked_at);
    const auto length = std::chrono::duration<double>(end.time - start.time).count();
    double residue = 0;
    double unevenness = 0;
    int looked_at = 0;
    for (std::size_t i = first + step; i < last; i += step, ++looked_at) {
        const Line line = ends.line(window.at(i));
        const double due = std::chrono::duration<double>(window.time(i) - start.time).count() / length;
        unevenness = std::max(unevenness, std::abs(line.share - due));
        if (unevenness >= (is_short ? uneven_if_short : uneven)) return false;
        residue += line.residue;
    }
    const double limit = is_short ? max_residue_if_short
                         : unevenness < even && end.time - start.time >= min_length_if_even
                             ? max_residue_if_even
                         : likeness < unlike ? max_residue_if_unlike
                                             : max_residue;
    return looked_at > 0 && residue / looked_at < limit;
}

// Says if hardly anything changes directly before and after a few frames that differ much.
bool stands_alone(const FeatureWindow& window, std::size_t first, std::size_t last) {
    double inside = 255;
    for (std::size_t i = first + 1; i <= last; ++i)
        inside = std::min(inside, window.step_at(i));
    const double before = first > window.first() ? window.step_at(first) : 0;
    const double after = last + 1 < window.end() ? window.step_at(last + 1) : 0;
    return std::max(before, after) <= max_step_outside * inside;
}

// The first frame of a short dissolve that ends with a frame.
std::optional<std::size_t> short_dissolve_to(const FeatureWindow& window, std::size_t frame,
                                             std::size_t since) {
    for (const std::size_t steps : short_steps) {
        if (frame < std::max(since, window.first()) + steps) break;
        const std::size_t first = frame - steps;
        if (window.time(frame) - window.time(first) <= max_short && stands_alone(window, first, frame) &&
            is_dissolve(window, first, frame, true))
            return first;
    }
    return std::nullopt;
}

}  // namespace

bool is_in_short_dissolve(const FeatureWindow& window, std::size_t frame) {
    for (std::size_t last = frame; last < std::min(frame + short_steps.back(), window.end()); ++last) {
        const auto first = short_dissolve_to(window, last, 0);
        if (first && *first < frame) return true;
    }
    return false;
}

std::optional<Transition> DissolveFinder::push(const FeatureWindow& window, std::size_t frame,
                                               std::size_t since) {
    std::size_t first = frame;
    std::optional<std::size_t> longest;
    for (const milliseconds length : windows) {
        while (first > window.first() && first > since && window.time(frame) - window.time(first) < length)
            --first;
        if (window.time(frame) - window.time(first) < length || frame - first < min_window_frames) continue;
        if (is_dissolve(window, first, frame, false)) longest = first;
    }
    if (!longest) longest = short_dissolve_to(window, frame, since);
    if (!longest) return open_ && window.time(frame) - open_->end > quiet ? finish() : std::nullopt;
    const Transition found{window.time(*longest), window.time(frame), ShotEnd::dissolve};
    if (!open_) open_ = found;
    open_->begin = std::min(open_->begin, found.begin);
    open_->end = found.end;
    return std::nullopt;
}

std::optional<Transition> DissolveFinder::finish() {
    return std::exchange(open_, std::nullopt);
}

std::optional<std::chrono::nanoseconds> DissolveFinder::open_since() const {
    return open_ ? std::optional(open_->begin) : std::nullopt;
}

}  // namespace vitrine::analyzer
