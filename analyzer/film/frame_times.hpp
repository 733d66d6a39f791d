#pragma once

#include <gst/gst.h>

#include <algorithm>
#include <chrono>

namespace vitrine::analyzer {

/// The times of a film's frames in stream time, to which a player can seek. Two passes over the same film
/// give the same times.
class FrameTimes {
  public:
    /// The time of the film's next sample.
    std::chrono::nanoseconds of(GstSample* sample) {
        using std::chrono::nanoseconds;
        const GstBuffer* buffer = gst_sample_get_buffer(sample);
        const GstClockTime time = gst_segment_to_stream_time(gst_sample_get_segment(sample), GST_FORMAT_TIME,
                                                             GST_BUFFER_PTS(buffer));
        const nanoseconds at = GST_CLOCK_TIME_IS_VALID(time) ? nanoseconds(time) : end_;
        constexpr nanoseconds usual{40'000'000};
        const nanoseconds length =
            GST_BUFFER_DURATION_IS_VALID(buffer) ? nanoseconds(GST_BUFFER_DURATION(buffer)) : usual;
        end_ = std::max(end_, at + length);
        return at;
    }

    /// The end of the frames so far.
    std::chrono::nanoseconds end() const { return end_; }

  private:
    std::chrono::nanoseconds end_{0};
};

}  // namespace vitrine::analyzer
