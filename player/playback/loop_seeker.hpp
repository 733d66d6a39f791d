#pragma once

#include "base/media/gst_ptr.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

namespace vitrine::player {

/// Sends a pipeline to places of a film and back to the begin of a part, loop after loop. It goes back by a
/// segment seek where the container can do that, which keeps the decoder running; else by a flushing seek.
/// For the thread that runs the pipeline.
class LoopSeeker {
  public:
    /// @param announce  called with GStreamer's number of a seek, before the seek is sent; empty: nobody
    explicit LoopSeeker(std::function<void(std::uint32_t seek)> announce = {})
        : announce_(std::move(announce)) {}

    /// @param pipeline      outlives this
    /// @param has_segments  the container can do segment seeks
    void set_pipeline(GstElement* pipeline, bool has_segments);

    /// The end of the part in the film; none: the film's own end.
    void set_end(std::optional<std::chrono::nanoseconds> end) { end_ = end; }

    /// Further flags of all seeks, GST_SEEK_FLAG_*.
    void set_flags(int flags) { flags_ = flags; }

    /// Goes to a place; all that was under way is dropped. False: the film cannot be searched.
    bool jump(std::chrono::nanoseconds place);

    /// Goes back to a place while the last pictures are still under way. False: that cannot be done, and is
    /// not tried again; jump() is the way.
    bool rewind(std::chrono::nanoseconds place);

    /// No more segment seeks.
    void forbid_segments() { has_segments_ = false; }

    /// True if a message says that a loop is over. A demuxer may have come to the end just before it was sent
    /// elsewhere: that end is not one.
    bool ends_a_loop(GstMessage* message) const;

  private:
    bool is_playing() const;
    bool seek(int flags, std::chrono::nanoseconds place);

    std::function<void(std::uint32_t seek)> announce_;
    GstElement* pipeline_ = nullptr;
    bool has_segments_ = false;
    int flags_ = 0;
    std::optional<std::chrono::nanoseconds> end_;
    std::uint32_t seek_ = 0;  // GStreamer's number of the last one
};

}  // namespace vitrine::player
