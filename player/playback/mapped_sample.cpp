#include "player/playback/mapped_sample.hpp"

#include <gst/video/video.h>

#include <cassert>

namespace vitrine {

namespace {

/// Keeps a picture's memory readable. The buffer is held by the map.
class Mapping {
  public:
    explicit Mapping(GstSample* sample) {
        GstVideoInfo info;
        const GstCaps* caps = gst_sample_get_caps(sample);
        if (caps == nullptr || !gst_video_info_from_caps(&info, caps)) return;
        assert(GST_VIDEO_INFO_FORMAT(&info) == GST_VIDEO_FORMAT_RGBA);
        is_mapped_ =
            gst_video_frame_map(&frame_, &info, gst_sample_get_buffer(sample), GST_MAP_READ) != FALSE;
    }

    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;
    Mapping(Mapping&&) = delete;
    Mapping& operator=(Mapping&&) = delete;

    ~Mapping() {
        if (is_mapped_) gst_video_frame_unmap(&frame_);
    }

    bool is_mapped() const { return is_mapped_; }

    const GstVideoFrame& frame() const { return frame_; }

  private:
    GstVideoFrame frame_{};
    bool is_mapped_ = false;
};

}  // namespace

std::optional<Sample> mapped(GstSample* sample, std::chrono::nanoseconds stream_time) {
    auto mapping = std::make_shared<Mapping>(sample);
    if (!mapping->is_mapped()) return std::nullopt;
    const GstVideoFrame& frame = mapping->frame();
    const auto stride = static_cast<std::size_t>(GST_VIDEO_FRAME_PLANE_STRIDE(&frame, 0));
    const auto* pixels = static_cast<const std::byte*>(GST_VIDEO_FRAME_PLANE_DATA(&frame, 0));
    return Sample{.width = GST_VIDEO_FRAME_WIDTH(&frame),
                  .height = GST_VIDEO_FRAME_HEIGHT(&frame),
                  .stride = stride,
                  .pixels = {pixels, stride * static_cast<std::size_t>(GST_VIDEO_FRAME_HEIGHT(&frame))},
                  .owner = std::move(mapping),
                  .stream_time = stream_time};
}

}  // namespace vitrine
