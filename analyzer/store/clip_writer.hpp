#pragma once

#include "analyzer/store/clip_reader.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace vitrine::analyzer {

/// Reports that a clip cannot be made.
class ClipError : public std::runtime_error {
  public:
    enum class Why {
        broken,     // the encoder refuses it
        too_large,  // it would have more bytes than allowed
        no_room,    // the disk is full
    };

    ClipError(Why why, const std::string& what) : std::runtime_error(what), why_(why) {}

    Why why() const { return why_; }

  private:
    Why why_;
};

/// Codes one shot so that it is cheap to play in a loop: H.264 in MP4, a key picture at its beginning and at
/// least one a second, no picture that refers to a later one, coding tools that are cheap to decode.
/// Measured at 640 x 360: a sixth of the decoding of a 720p film.
class ClipWriter {
  public:
    /// True where this machine can make clips at all.
    static bool has_encoder();

    /// @param file       replaced if there is one
    /// @param like       a frame of the film: the clip has its size, colours and rate
    /// @param max_bytes  for the clip
    ClipWriter(std::filesystem::path file, GstSample* like, std::uint64_t max_bytes);
    ClipWriter(const ClipWriter&) = delete;
    ClipWriter& operator=(const ClipWriter&) = delete;

    /// Removes an unfinished file.
    ~ClipWriter();

    /// @param time  from the beginning of the shot, later than the last
    /// @throws ClipError
    void push(GstSample* frame, std::chrono::nanoseconds time);

    /// Completes the file and gives it its name.
    /// @param end  the end of the last frame's time
    /// @throws ClipError
    void finish(std::chrono::nanoseconds end);

  private:
    void send(std::chrono::nanoseconds until);
    void wait_for_room();
    std::uint64_t size() const;

    std::filesystem::path file_;
    std::uint64_t max_bytes_;
    GstPtr<GstElement> pipeline_;
    GstPtr<GstElement> source_;
    GstPtr<GstBus> bus_;
    GstPtr<GstSample> held_;  // its duration is known when the next one comes
    std::chrono::nanoseconds held_time_{0};
    int frames_ = 0;
};

}  // namespace vitrine::analyzer
