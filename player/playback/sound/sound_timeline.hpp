#pragma once

#include "base/media/gst_ptr.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>

namespace vitrine::player {

/// Thread-safe. Places the loops of a part of a film on the running time of a pipeline, so that running time
/// is the time since the first loop's start. No loop's place depends on the end that a demuxer reports for
/// the loop before.
class SoundTimeline {
  public:
    /// @param begin     stream time of the part
    /// @param duration  the part's duration, > 0
    SoundTimeline(std::chrono::nanoseconds begin, std::chrono::nanoseconds duration)
        : begin_(begin), duration_(duration) {}

    /// Tells that the segments of this seek belong to this loop; the first loop is 0.
    void expect(std::uint32_t seek, std::int64_t loop);

    /// Returns a segment event with its place set. @param is_stamped  its times are stream times
    /// (media_type.hpp)
    GstPtr<GstEvent> placed(GstEvent* segment, bool is_stamped);

  private:
    std::chrono::nanoseconds begin_;
    std::chrono::nanoseconds duration_;
    std::mutex mutex_;
    std::map<std::uint32_t, std::int64_t> loops_;  // guarded by mutex_; key: number of a seek under way
    std::int64_t loop_ = 0;                        // guarded by mutex_; loop of the last segment
};

}  // namespace vitrine::player
