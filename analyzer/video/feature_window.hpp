#pragma once

#include "analyzer/video/frame_features.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <deque>

namespace vitrine {

/// The last seconds of a film's features. Frames are numbered from the film's start; old ones are forgotten.
class FeatureWindow {
  public:
    static constexpr std::chrono::seconds span{6};
    static constexpr std::size_t max_frames = 900;  // 6 s at 150 frames a second

    void push(const FrameFeatures& features) {
        step_.push_back(frames_.empty() ? 0 : colour_difference(frames_.back(), features));
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

    /// Colour difference of a frame to the one before it.
    double step_at(std::size_t frame) const { return step_[frame - first_]; }

    std::chrono::nanoseconds time(std::size_t frame) const { return at(frame).time; }

    /// The frame `count` before, but no earlier than the oldest.
    std::size_t before(std::size_t frame, std::size_t count) const {
        return frame - std::min(count, frame - first_);
    }

    /// The frame `count` after, but no later than the newest.
    std::size_t after(std::size_t frame, std::size_t count) const {
        return std::min(frame + count, end() - 1);
    }

  private:
    std::size_t first_ = 0;
    std::deque<FrameFeatures> frames_;
    std::deque<double> step_;
};

}  // namespace vitrine
