#pragma once

#include "base/media/gst_ptr.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

namespace vitrine::player {

/// Seeks in a film: to any place, and back to the start of a part, loop after loop. It goes back by a segment
/// seek if the container can do it, which keeps the decoder running; else by a flushing seek. For the thread
/// that runs the pipeline.
class LoopSeeker {
  public:
    /// @param announce  called with GStreamer's number of each seek before the seek is sent; may be empty
    explicit LoopSeeker(std::function<void(std::uint32_t seek)> announce = {})
        : announce_(std::move(announce)) {}

    /// @param pipeline      outlives this
    /// @param has_segments  the container can do segment seeks
    void set_pipeline(GstElement* pipeline, bool has_segments);

    /// The end of the part in the film; none: the film's own end.
    void set_end(std::optional<std::chrono::nanoseconds> end) { end_ = end; }

    /// Sets further flags for all seeks, GST_SEEK_FLAG_*.
    void set_flags(int flags) { flags_ = flags; }

    /// Goes to a place and drops all pictures under way. False: the film cannot seek.
    bool jump(std::chrono::nanoseconds place);

    /// Goes back to a place while the last pictures are still under way. False: this is impossible and will
    /// not be tried again; use jump().
    bool rewind(std::chrono::nanoseconds place);

    /// Uses no segment seek from now on.
    void forbid_segments() { has_segments_ = false; }

    /// True if the message says that a loop is over. An end that the demuxer reached just before the last
    /// seek does not count.
    bool ends_a_loop(GstMessage* message) const;

  private:
    bool is_playing() const;
    bool seek(int flags, std::chrono::nanoseconds place);

    std::function<void(std::uint32_t seek)> announce_;
    GstElement* pipeline_ = nullptr;
    bool has_segments_ = false;
    int flags_ = 0;
    std::optional<std::chrono::nanoseconds> end_;
    std::uint32_t seek_ = 0;  // GStreamer's number of the last seek
};

}  // namespace vitrine::player
