#pragma once

#include "analyzer/film/frame_times.hpp"
#include "analyzer/store/clip_form.hpp"
#include "base/media/decode_chain.hpp"
#include "base/media/tone_map.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace vitrine::analyzer {

/// A frame of a film in the form of a clip.
struct ClipFrame {
    GstPtr<GstSample> sample;
    std::chrono::nanoseconds time{0};  // since the beginning of the film
};

/// Reads the frames of a film one after another, in the form of its clips. It is not FilmSource: the analysis
/// is ahead of the clips by seconds, and these frames would have to be kept in memory, uncoded.
class ClipReader {
  public:
    /// @throws MediaError where the film cannot be decoded
    ClipReader(const std::string& film, const ClipForm& form);

    /// The next frame; nothing at the end. @throws MediaError where the film breaks off
    std::optional<ClipFrame> next();

  private:
    GstPtr<GstSample> toned(GstPtr<GstSample> sample) const;

    std::optional<ToneMap> tones_;  // only for an HDR film
    DecodeChain chain_;
    GstPtr<GstElement> sink_;
    FrameTimes times_;
    std::chrono::nanoseconds last_{-1};  // the last frame's time, -1: none yet
};

}  // namespace vitrine::analyzer
