#pragma once

#include "analyzer/film/film_frame.hpp"
#include "base/state/record.hpp"

#include <gst/video/video.h>

#include <optional>

namespace vitrine::analyzer {

/// The facts about a medium that are known before its pictures are read.
struct MediaInfo {
    MediaKind kind = MediaKind::photo;
    int width = 0;  // px of the upright picture at full size, square pixels
    int height = 0;
    std::chrono::nanoseconds duration{0};  // 0 for a photo; a film's may turn out shorter
    MediaOrigin origin;                    // empty: it was not asked
    GstVideoColorimetry colours{};         // a film's colours
    GstVideoOrientationMethod turn = GST_VIDEO_ORIENTATION_IDENTITY;  // makes a film's frames upright
};

/// Gives the pictures of a medium one after another, each once: a photo, a film, or a test's drawing.
class FrameSource {
  public:
    FrameSource() = default;
    FrameSource(const FrameSource&) = delete;
    FrameSource& operator=(const FrameSource&) = delete;
    virtual ~FrameSource() = default;

    virtual const MediaInfo& info() const = 0;

    /// The next picture in time order, nothing at the end.
    /// @throws MediaError where the medium turns out to be broken
    virtual std::optional<FilmFrame> next() = 0;
};

}  // namespace vitrine::analyzer
