#pragma once

#include "base/state/record.hpp"

#include <gst/video/video.h>
#include <opencv2/core.hpp>

#include <chrono>
#include <functional>
#include <optional>

namespace vitrine::analyzer {

/// One decoded picture as the analysis sees it.
struct FilmFrame {
    cv::Mat picture;                   // CV_8UC3, BGR, upright, square pixels, longest side <= analysis size
    std::chrono::nanoseconds time{0};  // stream time, to which a player can seek; 0 for a photo
    /// Makes the same picture with up to twice as many px a side, to search it for what is small. It keeps
    /// the decoded frame in memory, and the frame's source must outlive it. Null: `picture` has all px that
    /// the source has.
    std::function<cv::Mat()> finer;
};

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
