#pragma once

#include "player/playback/sound/sound_sink.hpp"

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::player {

/// The coding of a film that the test draws.
struct SoundingFilm {
    std::string picture = "jpegenc";
    std::string muxer = "qtmux";
    std::string encoder = "avenc_aac";  // the sound's; empty: no sound
    int seconds = 6;
};

/// Writes a film in whose second i a tone of tone_of(i) is heard. @throws std::runtime_error
void write_sounding_film(const std::string& file, const SoundingFilm& film = {});

/// Takes what a device would play, as fast as the test asks for it.
class SoundRecorder {
  public:
    /// One piece of the sound that was heard without a gap.
    struct Piece {
        std::chrono::nanoseconds time{0};  // running time of the first sample
        int rate = 0;
        std::vector<float> samples;  // the first channel's

        std::chrono::nanoseconds duration() const {
            return std::chrono::nanoseconds(std::chrono::seconds(1)) * static_cast<long>(samples.size()) /
                   rate;
        }
    };

    /// Makes sinks that this records from, one after the other.
    SoundSink sink();

    /// The number of sinks made.
    std::size_t sinks() const;

    /// The next sound of the newest sink, of this length; less where there is no more within a minute.
    std::vector<Piece> take(std::chrono::nanoseconds duration);

    /// The sound that waits to be taken.
    void throw_away();

  private:
    struct Made;

    GstAppSink* newest() const;

    std::shared_ptr<Made> made_;  // shared with the threads that ask for sinks
};

/// The second of a film whose tone is heard in these samples; -1: silence, or none.
int second_heard(const float* samples, std::size_t count, int rate);

}  // namespace vitrine::player
