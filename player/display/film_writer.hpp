#pragma once

#include "player/display/picture.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

namespace vitrine::player {

/// Writes pictures into an MP4 file (H.264) in fragments: it starts to play before it is loaded whole, a film
/// that is cut off plays up to its last fragment, and memory does not grow with the film. Encodes on
/// GStreamer's threads; add() waits if the encoder falls behind by more than a few pictures.
class FilmWriter {
  public:
    /// @param rate  frames a second that are written into the film's header, > 0
    /// @throws std::runtime_error naming the film: an encoder is missing, or the file cannot be written
    FilmWriter(const std::filesystem::path& path, int width, int height, double rate);
    FilmWriter(const FilmWriter&) = delete;
    FilmWriter& operator=(const FilmWriter&) = delete;
    FilmWriter(FilmWriter&&) = delete;
    FilmWriter& operator=(FilmWriter&&) = delete;

    /// Ends the film if finish() was not called. A failure then only leaves a broken file.
    ~FilmWriter();

    /// Shows `picture` in the film from `time` on, counted from the first picture's time. A picture that is
    /// not later than the last one is left out.
    /// @throws std::runtime_error naming the film
    void add(const Picture& picture, std::chrono::nanoseconds time);

    /// Ends the film and completes the file. Call add() no more.
    /// @throws std::runtime_error naming the film
    void finish();

  private:
    struct Chain;

    std::unique_ptr<Chain> chain_;
};

}  // namespace vitrine::player
