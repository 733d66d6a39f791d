#include "analyzer/film/standing_picture.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {

namespace {

constexpr double flat = 2;  // grey levels of deviation: a picture of one colour
// Shares of the largest difference on the way: less counts to the shot.
constexpr double max_faded = .25;
constexpr double max_dissolved = .2;
// Shares of a shot's contrast and of its distance from the plain picture: a picture so lit shows all there
// is.
constexpr double min_contrast = .72;
constexpr double min_light = .6;

/// Tells the frames of a transition that still show one of its ends.
class End {
  public:
    End(const FeatureWindow& window, std::size_t end, std::size_t first, std::size_t last)
        : window_(window), end_(end), plain_(first) {
        for (std::size_t i = first; i <= last; ++i) {
            largest_ = std::max(largest_, picture_difference(window.at(end), window.at(i)));
            if (window.at(i).deviation < window.at(plain_).deviation) plain_ = i;
        }
    }

    bool stands_at(std::size_t frame, ShotEnd kind) const {
        const double difference = picture_difference(window_.at(end_), window_.at(frame));
        if (kind != ShotEnd::fade) return difference <= max_dissolved * largest_;
        return difference <= max_faded * largest_ || is_lit(window_.at(frame));
    }

  private:
    bool is_lit(const FrameFeatures& frame) const {
        const FrameFeatures& full = window_.at(end_);
        const double plain = window_.at(plain_).mean;
        return frame.deviation >= min_contrast * full.deviation &&
               std::abs(frame.mean - plain) >= min_light * std::abs(full.mean - plain);
    }

    const FeatureWindow& window_;  // outlives this
    std::size_t end_;
    std::size_t plain_;  // the plainest frame
    double largest_ = 0;
};

}  // namespace

std::size_t stands_until(const FeatureWindow& window, std::size_t first, std::size_t last, ShotEnd kind) {
    const End end(window, first, first, last);
    std::size_t frame = first;
    while (frame < last && end.stands_at(frame, kind))
        ++frame;
    return frame;
}

std::size_t stands_from(const FeatureWindow& window, std::size_t first, std::size_t last, ShotEnd kind) {
    const End end(window, last, first, last);
    std::size_t frame = last;
    while (frame > first && end.stands_at(frame - 1, kind))
        --frame;
    return frame;
}

Transition without_standing(const FeatureWindow& window, const Transition& dissolve) {
    const std::size_t first = window.frame_at(dissolve.begin);
    const std::size_t last = window.frame_at(dissolve.end);
    bool is_fade = false;
    for (std::size_t i = first; i <= last; ++i)
        is_fade = is_fade || window.at(i).deviation < flat;
    const ShotEnd kind = is_fade ? ShotEnd::fade : dissolve.kind;
    const std::size_t begin = stands_until(window, first, last, kind);
    const std::size_t end = stands_from(window, begin, last, kind);
    return {window.time(begin), window.time(end), kind};
}

}  // namespace vitrine::analyzer
