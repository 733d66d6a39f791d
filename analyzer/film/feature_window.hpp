#pragma once

#include "analyzer/film/frame_features.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <deque>

namespace vitrine::analyzer {

/// The last seconds of a film's features. Frames are numbered from the film's start; old ones are forgotten.
class FeatureWindow {
  public:
    static constexpr std::chrono::seconds span{6};
    static constexpr std::size_t max_frames = 900;  // 6 s at 150 frames a second

    void push(const FrameFeatures& features) {
        step_.push_back(frames_.empty() ? 0 : picture_difference(frames_.back(), features));
        frames_.push_back(features);
        while (frames_.size() > max_frames || frames_.back().time - frames_.front().time > span) {
            frames_.pop_front();
            step_.pop_front();
            ++first_;
        }
    }

    std::size_t first() const { return first_; }  // the oldest frame still known

    std::size_t end() const { return first_ + frames_.size(); }  // one past the newest

    const FrameFeatures& at(std::size_t frame) const {
        assert(frame >= first_ && frame < end());
        return frames_[frame - first_];
    }

    /// Picture difference of a frame to the one before it, grey levels.
    double step_at(std::size_t frame) const { return step_[frame - first_]; }

    std::chrono::nanoseconds time(std::size_t frame) const { return at(frame).time; }

    /// The first frame that is not before a time, or the newest.
    std::size_t frame_at(std::chrono::nanoseconds time) const {
        const auto found =
            std::lower_bound(frames_.begin(), frames_.end(), time,
                             [](const FrameFeatures& frame, auto at) { return frame.time < at; });
        return std::min(first_ + static_cast<std::size_t>(found - frames_.begin()), end() - 1);
    }

    /// The last frame at least so long before a frame, or the oldest.
    std::size_t back(std::size_t frame, std::chrono::nanoseconds by) const {
        std::size_t other = frame;
        while (other > first_ && time(frame) - time(other) < by)
            --other;
        return other;
    }

    /// The first frame at least so long after a frame, or the newest.
    std::size_t ahead(std::size_t frame, std::chrono::nanoseconds by) const {
        std::size_t other = frame;
        while (other + 1 < end() && time(other) - time(frame) < by)
            ++other;
        return other;
    }

  private:
    std::size_t first_ = 0;
    std::deque<FrameFeatures> frames_;
    std::deque<double> step_;
};

}  // namespace vitrine::analyzer
