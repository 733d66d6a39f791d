#include "analyzer/film/photo_source.hpp"

#include <opencv2/imgproc.hpp>

#include <utility>

namespace vitrine::analyzer {

PhotoSource::PhotoSource(const std::string& path, int analysis_size, Colour background) {
    StillPicture picture = load_still(path, analysis_size, analysis_size, background);
    info_ = {.kind = MediaKind::photo, .width = picture.full.width, .height = picture.full.height};
    const cv::Mat rgba(picture.height, picture.width, CV_8UC4, picture.pixels.data());
    frame_.emplace();
    cv::cvtColor(rgba, frame_->picture, cv::COLOR_RGBA2BGR);
}

std::optional<FilmFrame> PhotoSource::next() {
    return std::exchange(frame_, std::nullopt);
}

}  // namespace vitrine::analyzer
