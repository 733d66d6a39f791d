#include "analyzer/video/photo_source.hpp"

#include <opencv2/imgproc.hpp>

#include <utility>

namespace vitrine {

PhotoSource::PhotoSource(const std::string& path, int analysis_size, Colour background) {
    const StillInfo still = probe_still(path);
    info_ = {.kind = MediaKind::photo, .width = still.width, .height = still.height};
    StillPicture picture = load_still(path, analysis_size, analysis_size, background);
    const cv::Mat rgba(picture.height, picture.width, CV_8UC4, picture.pixels.data());
    frame_.emplace();
    cv::cvtColor(rgba, frame_->picture, cv::COLOR_RGBA2BGR);
}

std::optional<VideoFrame> PhotoSource::next() {
    return std::exchange(frame_, std::nullopt);
}

}  // namespace vitrine
