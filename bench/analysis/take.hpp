#pragma once

#include "analyzer/film/frame_source.hpp"
#include "analyzer/saliency/analysis_settings.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// A film of one shot whose subject is known in every frame.
struct Take {
    std::string name;
    double fps = 25;
    std::vector<cv::Mat> frames;  // BGR
    std::vector<cv::Mat> masks;   // CV_8UC1, 255 where the subject is, of the frames' size
};

/// FOLDER/frames and FOLDER/masks, pictures in the order of their names. @pre both folders exist
Take read_take(const std::filesystem::path& folder, int side);

/// The frames of a take as the analysis reads a film.
class TakeSource : public FrameSource {
  public:
    explicit TakeSource(const Take& take);

    const MediaInfo& info() const override { return info_; }

    std::optional<FilmFrame> next() override;

  private:
    const Take& take_;  // outlives the source
    MediaInfo info_;
    std::size_t count_ = 0;
};

/// The same after H.264 at a film's usual quality, with the flow noise that brings; the plain frames where
/// ffmpeg is not installed.
class EncodedTake {
  public:
    explicit EncodedTake(const Take& take);
    EncodedTake(const EncodedTake&) = delete;
    EncodedTake& operator=(const EncodedTake&) = delete;
    ~EncodedTake();

    MediaRecord analyzed(const AnalysisSettings& settings) const;

  private:
    const Take& take_;            // outlives the file
    std::filesystem::path file_;  // empty where there is none
};

/// The place of a film's region at a time, px of the source; empty between shots.
Polygon region_at(const MediaRecord& record, std::chrono::nanoseconds time);

}  // namespace vitrine::analyzer
