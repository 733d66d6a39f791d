#pragma once

#include "analyzer/film/frame_features.hpp"

#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The likeness of a frame to the first of a new shot, as another detector sees it.
struct Suspicion {
    std::chrono::nanoseconds time{0};
    double score = 0;
};

/// ffmpeg's scdet: the score of every frame above 1. Runs ffmpeg; empty where it cannot.
std::vector<Suspicion> scdet_scores(const std::string& path);

/// PySceneDetect's adaptive detector, rewritten: the mean change of hue, saturation and value against its
/// mean over two frames before and two after; 0 where the change itself is below 15.
class AdaptiveDetector {
  public:
    void push(const FilmFrame& frame);

    std::vector<Suspicion> finish() const;

  private:
    cv::Mat last_;
    std::vector<Suspicion> changes_;
};

/// One step of the colour histogram after another.
class HistogramDetector {
  public:
    void push(const FrameFeatures& frame);

    const std::vector<Suspicion>& finish() const { return steps_; }

  private:
    bool is_begun_ = false;
    FrameFeatures last_;
    std::vector<Suspicion> steps_;
};

}  // namespace vitrine::analyzer
