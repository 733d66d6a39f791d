#pragma once

#include <gst/gst.h>

#include <atomic>

namespace vitrine::player {

/// Fades a sound in and out, linearly within a fifth of a second. For the streaming thread, except leave().
class SoundFade {
  public:
    /// Fades out from now on. Thread-safe.
    void leave() { is_leaving_ = true; }

    /// Starts again from silence.
    void come() { gain_ = 0; }

    /// Applies the fade to a buffer of interleaved float samples.
    /// @param buffer  writable
    void apply(GstBuffer* buffer, int rate, int channels);

    /// True once it has faded out.
    bool is_silent() const { return is_leaving_ && gain_ <= 0; }

  private:
    std::atomic<bool> is_leaving_{false};
    double gain_ = 0;  // in [0, 1]
};

}  // namespace vitrine::player
