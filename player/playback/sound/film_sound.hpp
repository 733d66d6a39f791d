#pragma once

#include "player/playback/pipeline_control.hpp"
#include "player/playback/sound/sound_sink.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace vitrine::player {

/// A part of a film whose sound is played in a loop, in time with its picture.
struct SoundPart {
    std::string file;
    std::chrono::nanoseconds begin{0};  // half-open [begin, end) in stream time
    std::chrono::nanoseconds end{0};
    std::chrono::nanoseconds origin{0};  // time of its first loop's start, by the monotonic clock

    std::chrono::nanoseconds duration() const { return std::max(end - begin, std::chrono::nanoseconds(1)); }
};

/// Plays the sound of a part of a film, in threads of its own. Throws nothing: failure() reports.
///
/// The wall's clock is the master. The pipeline runs on the monotonic clock. Each loop's segment is placed by
/// its place in the part, however the demuxer counts. So running time is the shot's own time, and loops do
/// not drift. The sink corrects a sound card whose clock runs a little faster. The sound fades in and out
/// within a fifth of a second.
class FilmSound {
  public:
    FilmSound(const SoundPart& part, const SoundSink& make_sink);
    FilmSound(const FilmSound&) = delete;
    FilmSound& operator=(const FilmSound&) = delete;
    FilmSound(FilmSound&&) = delete;
    FilmSound& operator=(FilmSound&&) = delete;

    /// Waits for its thread, but not for ever: if a device does not answer, the thread is left behind with
    /// its objects.
    ~FilmSound();

    /// Starts to fade out. The sound ends afterwards.
    void leave();

    bool has_ended() const;

    /// True once sound has reached the device.
    bool is_heard() const;

    /// The reason why it ended by itself.
    std::optional<PlaybackFailure> failure() const;

  private:
    class Work;

    std::shared_ptr<Work> work_;  // shared with the thread, which may be left behind
    std::thread thread_;
};

}  // namespace vitrine::player
