#include "analyzer/status/thumbnail.hpp"

#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <opencv2/imgproc.hpp>
#include <vips/vips.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <system_error>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr int max_side = 240;  // px
constexpr int quality = 75;
constexpr std::size_t max_frames = 24;
constexpr auto between_frames = std::chrono::milliseconds(500);

struct Unref {
    void operator()(VipsImage* image) const { g_object_unref(image); }
};

struct Free {
    void operator()(void* memory) const { g_free(memory); }
};

/// The region as it lies in this frame, thumbnail px.
std::vector<cv::Point> outline(const MediaRecord& record, const Shot& shot, const FilmFrame& frame,
                               cv::Size size) {
    constexpr int shift = 16;  // fraction bits of a coordinate for cv::polylines
    const double seconds = std::chrono::duration<double>(frame.time - shot.begin).count();
    std::vector<cv::Point> corners;
    for (const Vec2 corner : shot.region.polygon) {
        const Vec2 at = corner + shot.region.drift * seconds;
        corners.emplace_back(
            static_cast<int>(std::lround(at.x / record.width * size.width * (1 << shift))),
            static_cast<int>(std::lround(at.y / record.height * size.height * (1 << shift))));
    }
    return corners;
}

/// The picture within its bars, thumbnail px.
cv::Rect active_part(const MediaRecord& record, const Shot& shot, cv::Size size) {
    const Box active = active_picture(record, shot);
    const double x = static_cast<double>(size.width) / record.width;
    const double y = static_cast<double>(size.height) / record.height;
    const cv::Rect part(cv::Point(cvRound(active.min.x * x), cvRound(active.min.y * y)),
                        cv::Point(cvRound(active.max.x * x), cvRound(active.max.y * y)));
    const cv::Rect whole({0, 0}, size);
    return (part & whole).empty() ? whole : part & whole;
}

/// Draws a light line within a dark one: it is seen on any picture.
void draw(cv::Mat& picture, const std::vector<cv::Point>& corners) {
    constexpr int shift = 16;
    const cv::Scalar dark(30, 30, 30);
    const cv::Scalar light(80, 230, 255);  // BGR: yellow
    cv::polylines(picture, corners, true, dark, 4, cv::LINE_AA, shift);
    cv::polylines(picture, corners, true, light, 2, cv::LINE_AA, shift);
}

/// @return empty where it cannot be made
std::string jpeg(const cv::Mat& bgr) {
    cv::Mat rgb;
    cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
    const std::unique_ptr<VipsImage, Unref> image(vips_image_new_from_memory(
        rgb.data, rgb.total() * rgb.elemSize(), rgb.cols, rgb.rows, 3, VIPS_FORMAT_UCHAR));
    if (!image) return {};
    void* bytes = nullptr;
    std::size_t size = 0;
    if (vips_jpegsave_buffer(image.get(), &bytes, &size, "Q", quality, "strip", TRUE, nullptr) != 0)
        return {};
    const std::unique_ptr<void, Free> owned(bytes);
    return {static_cast<const char*>(bytes), size};
}

}  // namespace

void Thumbnail::add_frame(const FilmFrame& frame) {
    if (is_written_ || frame.picture.empty() || frames_.size() >= max_frames) return;
    if (!frames_.empty() && frame.time < frames_.back().time + between_frames) return;
    const int side = std::max(frame.picture.cols, frame.picture.rows);
    const double scale = std::min(1.0, static_cast<double>(max_side) / side);
    FilmFrame small{.picture = {}, .time = frame.time, .finer = {}};
    const cv::Size size(std::max(1, cvRound(frame.picture.cols * scale)),
                        std::max(1, cvRound(frame.picture.rows * scale)));
    cv::resize(frame.picture, small.picture, size, 0, 0, cv::INTER_AREA);
    frames_.push_back(std::move(small));
}

/// The first kept frame of the shot.
const FilmFrame* Thumbnail::frame_of(const Shot& shot) const {
    const auto found =
        std::ranges::find_if(frames_, [&](const FilmFrame& frame) { return frame.time >= shot.begin; });
    return found == frames_.end() || (shot.end > shot.begin && found->time >= shot.end) ? nullptr : &*found;
}

void Thumbnail::write(const MediaRecord& record) {
    if (is_written_ || record.shots.empty() || record.width <= 0 || record.height <= 0) return;
    is_written_ = true;
    const Shot& shot = record.shots.front();
    const FilmFrame* frame = frame_of(shot);
    if (frame == nullptr) return;
    cv::Mat picture = frame->picture.clone();
    draw(picture, outline(record, shot, *frame, picture.size()));
    picture = picture(active_part(record, shot, picture.size())).clone();
    frames_.clear();
    try {
        fs::create_directories(file_.parent_path());
        if (const std::string content = jpeg(picture); !content.empty()) replace_file(file_, content);
    } catch (const std::system_error& error) {
        log::debug("no thumbnail: {}", error.what());
    }
}

}  // namespace vitrine::analyzer
