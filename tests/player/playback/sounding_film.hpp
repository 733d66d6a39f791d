#pragma once

#include "player/playback/sound_sink.hpp"

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::player {

/// How a film is coded that the test draws.
struct SoundingFilm {
    std::string picture = "jpegenc";
    std::string muxer = "qtmux";
    std::string encoder = "avenc_aac";  // of the sound; empty: it has none
    int seconds = 6;
};

/// Writes a film in whose second i a tone of tone_of(i) is heard. @throws std::runtime_error
void write_sounding_film(const std::string& file, const SoundingFilm& film = {});

/// Takes what a device would play, as fast as the test asks for it.
class SoundRecorder {
  public:
    /// What was heard, a piece in one go.
    struct Piece {
        std::chrono::nanoseconds time{0};  // running time of the first sample
        int rate = 0;
        std::vector<float> samples;  // of the first channel

        std::chrono::nanoseconds duration() const {
            return std::chrono::nanoseconds(std::chrono::seconds(1)) * static_cast<long>(samples.size()) /
                   rate;
        }
    };

    /// Of which each sink made is one after the other recorded from.
    SoundSink sink();

    /// How many sinks were made.
    std::size_t sinks() const;

    /// What the newest sink gets next, so much of it; less where there is no more within a minute.
    std::vector<Piece> take(std::chrono::nanoseconds duration);

    /// What waits to be taken.
    void throw_away();

  private:
    struct Made;

    GstAppSink* newest() const;

    std::shared_ptr<Made> made_;  // shared with the threads that ask for sinks
};

/// The second of a film whose tone is heard in these samples; -1: silence, or none.
int second_heard(const float* samples, std::size_t count, int rate);

}  // namespace vitrine::player
