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

/// A part of a film to be heard over and over, in time with its picture.
struct SoundPart {
    std::string file;
    std::chrono::nanoseconds begin{0};  // half-open [begin, end) in stream time
    std::chrono::nanoseconds end{0};
    std::chrono::nanoseconds origin{0};  // by the monotonic clock: when its first loop began

    std::chrono::nanoseconds duration() const { return std::max(end - begin, std::chrono::nanoseconds(1)); }
};

/// Plays the sound of a part of a film, in threads of its own; failures are told, not thrown.
///
/// The wall's clock is the master: the time of the sound's pipeline is the monotonic clock, and each loop's
/// segment is placed on it by what it is of the part, however the demuxer counts. So running time is the
/// shot's own time, loops do not drift, and a sound card whose clock runs a little faster is the sink's
/// matter. It comes and goes within a fifth of a second.
class FilmSound {
  public:
    FilmSound(const SoundPart& part, const SoundSink& make_sink);
    FilmSound(const FilmSound&) = delete;
    FilmSound& operator=(const FilmSound&) = delete;
    FilmSound(FilmSound&&) = delete;
    FilmSound& operator=(FilmSound&&) = delete;

    /// Waits for its thread, not for ever: a device that does not answer keeps it, and what belongs to it.
    ~FilmSound();

    /// Begins to fade out, and then to end.
    void leave();

    bool has_ended() const;

    /// True once any of it has reached the device.
    bool is_heard() const;

    /// The reason why it ended by itself.
    std::optional<PlaybackFailure> failure() const;

  private:
    class Work;

    std::shared_ptr<Work> work_;  // shared with the thread, which may have to be left behind
    std::thread thread_;
};

}  // namespace vitrine::player
