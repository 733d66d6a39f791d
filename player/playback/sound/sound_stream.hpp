#pragma once

#include "player/playback/pipeline_control.hpp"
#include "player/playback/sound/sound_fade.hpp"
#include "player/playback/sound/sound_timeline.hpp"

#include <atomic>
#include <chrono>

namespace vitrine::player {

/// The streaming side of a film's sound: puts each loop at its place on the wall's clock, and fades the sound
/// in and out. GStreamer's streaming thread calls it; other threads call only the thread-safe methods.
class SoundStream {
  public:
    /// Name of the message that is posted to the pipeline's thread once the sound has faded out.
    static constexpr const char* silent_word = "vitrine-silent";

    /// @param begin, duration  the part's, in stream time
    /// @param control          the pipeline's control; outlives this
    SoundStream(std::chrono::nanoseconds begin, std::chrono::nanoseconds duration, PipelineControl& control)
        : timeline_(begin, duration), control_(control) {}

    /// Watches a pad in front of the sink. This outlives the pipeline.
    /// @param is_stamped  the film's time stamps are stream times (media_type.hpp)
    void connect(GstPad* pad, bool is_stamped);

    /// Tells that this seek starts this loop of the part; the first loop is 0. Thread-safe.
    void expect_loop(std::uint32_t seek, std::int64_t loop) { timeline_.expect(seek, loop); }

    /// Starts to fade out. Thread-safe.
    void fade_out() { fade_.leave(); }

    /// True once any sound has reached the sink. Thread-safe.
    bool is_heard() const { return is_heard_; }

    /// True if there was any sound since the last call. Thread-safe.
    bool take_sounded() { return has_sounded_.exchange(false); }

  private:
    static GstPadProbeReturn on_event(GstPad* pad, GstPadProbeInfo* info, gpointer self);
    static GstPadProbeReturn on_buffer(GstPad* pad, GstPadProbeInfo* info, gpointer self);

    SoundTimeline timeline_;
    PipelineControl& control_;  // outlives this
    SoundFade fade_;
    bool is_stamped_ = false;
    bool is_silent_ = false;
    std::atomic<bool> has_sounded_{false};
    std::atomic<bool> is_heard_{false};
};

}  // namespace vitrine::player
