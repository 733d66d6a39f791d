#pragma once

#include <gst/gst.h>

#include <atomic>

namespace vitrine::player {

/// How loud a sound is while it comes and goes: by a straight line within a fifth of a second. For the
/// streaming thread, but for leave().
class SoundFade {
  public:
    /// From here on it goes. Thread-safe.
    void leave() { is_leaving_ = true; }

    /// It begins anew, from silence.
    void come() { gain_ = 0; }

    /// Makes a buffer of float samples, interleaved, as loud as it shall be.
    /// @param buffer  writable
    void apply(GstBuffer* buffer, int rate, int channels);

    /// It has gone.
    bool is_silent() const { return is_leaving_ && gain_ <= 0; }

  private:
    std::atomic<bool> is_leaving_{false};
    double gain_ = 0;  // in [0, 1]
};

}  // namespace vitrine::player
