#pragma once

#include "analyzer/film/frame_source.hpp"

#include <opencv2/imgproc.hpp>

#include <chrono>

namespace vitrine::analyzer {

/// A ball that crosses one scene after another; or nothing at all.
class DrawnSource : public FrameSource {
  public:
    DrawnSource(cv::Size size, int frames, bool is_black)
        : size_(size), frames_(frames), is_black_(is_black) {
        info_.kind = MediaKind::film;
        info_.width = size.width;
        info_.height = size.height;
        info_.duration = std::chrono::milliseconds(100) * frames;
    }

    const MediaInfo& info() const override { return info_; }

    std::optional<FilmFrame> next() override {
        if (next_ == frames_) return std::nullopt;
        FilmFrame frame{.picture = cv::Mat(size_, CV_8UC3, cv::Scalar::all(0)),
                        .time = std::chrono::milliseconds(100) * next_};
        if (!is_black_) {
            const int scene = next_ / 40;
            frame.picture.setTo(cv::Scalar(scene * 70 % 256, 120, 60));
            cv::circle(frame.picture, {next_ * 7 % size_.width, size_.height / 2}, size_.height / 5,
                       cv::Scalar(20, 220, 240), cv::FILLED);
        }
        ++next_;
        return frame;
    }

  private:
    cv::Size size_;
    int frames_;
    bool is_black_;
    int next_ = 0;
    MediaInfo info_;
};

}  // namespace vitrine::analyzer
