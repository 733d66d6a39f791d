#include "analyzer/film/fade_finder.hpp"

#include "analyzer/film/standing_picture.hpp"

#include <utility>

namespace vitrine::analyzer {

namespace {

constexpr double plain_deviation = 6;  // grey levels
constexpr double black = 14;
constexpr double white = 240;
constexpr std::chrono::milliseconds looked_over{120};  // time over which growth is measured
constexpr double growth = 1.02;                        // factor of the contrast in that time
constexpr std::chrono::milliseconds min_fade{120};     // a shorter ramp is a cut
constexpr std::chrono::seconds max_ramp{4};

bool is_plain(const FrameFeatures& frame) {
    return frame.deviation < plain_deviation && (frame.mean < black || frame.mean > white);
}

std::size_t frame_before(const FeatureWindow& window, std::size_t frame, std::size_t since) {
    std::size_t other = frame;
    while (other > window.first() && other > since && window.time(frame) - window.time(other) < looked_over)
        --other;
    return other;
}

// The frame at which the contrast began to fall towards the plain one.
std::size_t ramp_start(const FeatureWindow& window, std::size_t plain, std::size_t since) {
    std::size_t frame = plain;
    while (window.time(plain) - window.time(frame) < max_ramp) {
        const std::size_t earlier = frame_before(window, frame, since);
        if (earlier == frame || window.at(earlier).deviation < window.at(frame).deviation * growth) break;
        --frame;
    }
    return frame;
}

}  // namespace

bool FadeFinder::is_growing(const FeatureWindow& window, std::size_t frame) const {
    const std::size_t earlier = frame_before(window, frame, plain_end_ > 0 ? plain_end_ - 1 : 0);
    return window.time(frame) - window.time(std::max(window.first(), plain_end_)) < max_ramp &&
           window.at(frame).deviation > window.at(earlier).deviation * growth;
}

std::optional<Transition> FadeFinder::push(const FeatureWindow& window, std::size_t frame,
                                           std::size_t since) {
    if (is_plain(window.at(frame))) {
        if (!open_) {
            const std::size_t start = ramp_start(window, frame, since);
            const bool fades = window.time(frame) - window.time(start) > min_fade;
            const std::size_t begin = stands_until(window, start, frame, ShotEnd::fade);
            open_ = {window.time(begin), window.time(frame), fades ? ShotEnd::fade : ShotEnd::cut};
        }
        in_plain_ = true;
        plain_end_ = frame + 1;
        return std::nullopt;
    }
    if (!open_) return std::nullopt;
    if (in_plain_) open_->end = window.time(frame);
    in_plain_ = false;
    if (since == frame) {  // a cut away from the plain colour, or out of the ramp
        open_->end = window.time(frame);
        return std::exchange(open_, std::nullopt);
    }
    if (is_growing(window, frame)) {
        if (frame + 1 < window.end()) open_->end = window.time(frame + 1);
        if (window.time(frame) - window.time(std::max(window.first(), plain_end_)) > min_fade)
            open_->kind = ShotEnd::fade;
        return std::nullopt;
    }
    return closed(window);
}

/// The open fade, which ends where the picture stands.
Transition FadeFinder::closed(const FeatureWindow& window) {
    Transition found = *std::exchange(open_, std::nullopt);
    const std::size_t plain = std::max(window.first(), plain_end_ > 0 ? plain_end_ - 1 : 0);
    const std::size_t end = window.frame_at(found.end);
    if (end > plain) found.end = window.time(stands_from(window, plain, end, ShotEnd::fade));
    return found;
}

std::optional<Transition> FadeFinder::finish(std::chrono::nanoseconds end) {
    if (open_ && in_plain_) open_->end = end;
    return std::exchange(open_, std::nullopt);
}

std::optional<std::chrono::nanoseconds> FadeFinder::open_since() const {
    return open_ ? std::optional(open_->begin) : std::nullopt;
}

}  // namespace vitrine::analyzer
