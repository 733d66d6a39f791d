#pragma once

#include "analyzer/film/frame_source.hpp"
#include "base/media/still_picture.hpp"

#include <string>

namespace vitrine::analyzer {

/// A photo as a film of one frame.
class PhotoSource : public FrameSource {
  public:
    PhotoSource(const std::string& path, int analysis_size, Colour background);

    const MediaInfo& info() const override { return info_; }

    std::optional<FilmFrame> next() override;

  private:
    MediaInfo info_;
    std::optional<FilmFrame> frame_;
};

}  // namespace vitrine::analyzer
