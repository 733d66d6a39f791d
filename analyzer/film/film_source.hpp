#pragma once

#include "analyzer/film/frame_source.hpp"
#include "analyzer/film/frame_times.hpp"
#include "base/media/colour.hpp"
#include "base/media/decode_chain.hpp"
#include "base/media/tone_map.hpp"

#include <gst/video/video.h>

#include <chrono>
#include <memory>
#include <string>

namespace vitrine::analyzer {

/// The frames of a film, decoded as fast as they are asked for.
class FilmSource : public FrameSource {
  public:
    /// @param background  colour that shows through where the film is transparent
    /// @throws MediaError where the film is not complete, cannot be decoded or is beyond the limits of
    /// film_size.hpp
    FilmSource(const std::string& path, int analysis_size, Colour background = {});

    const MediaInfo& info() const override { return info_; }

    std::optional<FilmFrame> next() override;

  private:
    void read_geometry(int analysis_size);
    cv::Mat picture_of(GstSample* sample, cv::Size coded) const;
    FilmFrame frame_of(const std::shared_ptr<GstSample>& sample, std::chrono::nanoseconds time) const;
    void finish();

    DecodeChain chain_;
    GstPtr<GstElement> sink_;
    Colour background_;
    MediaInfo info_;
    GstVideoOrientationMethod turn_ = GST_VIDEO_ORIENTATION_IDENTITY;
    std::optional<ToneMap> tones_;  // for an HDR film
    cv::Size coded_size_;           // size of the small picture before it is turned
    cv::Size finer_size_;           // size of the finer picture before it is turned
    bool extent_known_ = false;     // the container said how long it is in bytes
    bool ended_ = false;
    std::chrono::nanoseconds last_{-1};  // stream time of the last frame, -1: none yet
    FrameTimes times_;
};

}  // namespace vitrine::analyzer
