#pragma once

#include "base/media/gst_ptr.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>

namespace vitrine::player {

/// Thread-safe. Places the loops of a part of a film on the running time of a pipeline, so that it is the
/// time since the first loop began: no loop depends on where a demuxer believes the one before it ended.
class SoundTimeline {
  public:
    /// @param begin     stream time of the part
    /// @param duration  the part's, > 0
    SoundTimeline(std::chrono::nanoseconds begin, std::chrono::nanoseconds duration)
        : begin_(begin), duration_(duration) {}

    /// The segments of this seek belong to that loop, the first being 0.
    void expect(std::uint32_t seek, std::int64_t loop);

    /// A segment event with its place. @param is_stamped  its times are stream times (container_ways.hpp)
    GstPtr<GstEvent> placed(GstEvent* segment, bool is_stamped);

  private:
    std::chrono::nanoseconds begin_;
    std::chrono::nanoseconds duration_;
    std::mutex mutex_;
    std::map<std::uint32_t, std::int64_t> loops_;  // guarded by mutex_: by numbers of seeks under way
    std::int64_t loop_ = 0;                        // guarded by mutex_: the last segment's
};

}  // namespace vitrine::player
