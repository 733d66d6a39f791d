#pragma once

#include "base/media/gst_ptr.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>

namespace vitrine::player {

/// The reason why a film or its sound ended by itself.
struct PlaybackFailure {
    std::string text;        // in plain words
    bool is_of_film = true;  // false: the device that plays it failed
};

/// Thread-safe. Lets other threads talk to the one thread that runs a GStreamer pipeline. Over the pipeline's
/// bus they post words and stop it; it reports how it ended.
class PipelineControl {
  public:
    /// Connects the bus of the new pipeline: words reach the caller of next_message().
    /// @param bus  lent until detach()
    /// @return false: stopped already, do not run the pipeline
    bool attach(GstBus* bus);

    /// Call before the bus is destroyed.
    void detach();

    /// Posts a word, as an application message of that name. Without a bus it is lost.
    void post(const char* word);

    /// Ends next_message() for good.
    void stop();

    /// The next message about a failure, an end, a reached state or a word. For the pipeline's own thread.
    /// @return none: stopped, or no message came within `patience`
    GstPtr<GstMessage> next_message(GstClockTime patience = GST_CLOCK_TIME_NONE) const;

    void set_failure(PlaybackFailure failure);
    std::optional<PlaybackFailure> failure() const;

    /// Call when the pipeline's thread has released everything.
    void set_ended();
    bool has_ended() const;

    /// Waits for set_ended(). False: not within `patience`.
    bool wait_for_end(std::chrono::nanoseconds patience) const;

  private:
    mutable std::mutex mutex_;
    mutable std::condition_variable ended_;
    GstBus* bus_ = nullptr;                   // guarded by mutex_ against other threads
    bool is_stopped_ = false;                 // guarded by mutex_
    bool has_ended_ = false;                  // guarded by mutex_
    std::optional<PlaybackFailure> failure_;  // guarded by mutex_
};

/// The element of that name in a bin.
GstPtr<GstElement> element_named(GstElement* bin, const char* name);

}  // namespace vitrine::player
