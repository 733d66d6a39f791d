#include "analyzer/film/frame_reader.hpp"

#include "analyzer/film/film_source.hpp"
#include "base/media/media_type.hpp"

#include <opencv2/imgproc.hpp>

#include <optional>
#include <utility>

namespace vitrine::analyzer {
namespace {

// Small faces need so many px. A film has them in FilmFrame::finer, and a photo in its only picture.
constexpr int photo_enlargement = 2;

// A photo as a film of one frame.
class PhotoSource : public FrameSource {
  public:
    PhotoSource(const std::string& path, int analysis_size, Colour background) {
        StillPicture picture = load_still(path, analysis_size, analysis_size, background);
        info_ = {.kind = MediaKind::photo, .width = picture.full.width, .height = picture.full.height};
        const cv::Mat rgba(picture.height, picture.width, CV_8UC4, picture.pixels.data());
        frame_.emplace();
        cv::cvtColor(rgba, frame_->picture, cv::COLOR_RGBA2BGR);
    }

    const MediaInfo& info() const override { return info_; }

    std::optional<FilmFrame> next() override { return std::exchange(frame_, std::nullopt); }

  private:
    MediaInfo info_;
    std::optional<FilmFrame> frame_;
};

}  // namespace

std::unique_ptr<FrameSource> open_media(const std::string& path, int analysis_size, Colour background) {
    if (kind_of(media_format(path)) == MediaKind::photo)
        return std::make_unique<PhotoSource>(path, photo_enlargement * analysis_size, background);
    return std::make_unique<FilmSource>(path, analysis_size, background);
}

}  // namespace vitrine::analyzer
