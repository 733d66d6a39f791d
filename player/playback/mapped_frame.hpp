#pragma once

#include "player/playback/sample.hpp"

#include <gst/video/video.h>

namespace vitrine::player {

/// The readable memory of a decoded frame. It stays mapped, and its buffer is kept, while this lives.
class MappedFrame {
  public:
    explicit MappedFrame(GstSample* sample) {
        GstVideoInfo info;
        const GstCaps* caps = gst_sample_get_caps(sample);
        if (caps == nullptr || !gst_video_info_from_caps(&info, caps)) return;
        is_mapped_ =
            gst_video_frame_map(&frame_, &info, gst_sample_get_buffer(sample), GST_MAP_READ) != FALSE;
    }

    MappedFrame(const MappedFrame&) = delete;
    MappedFrame& operator=(const MappedFrame&) = delete;
    MappedFrame(MappedFrame&&) = delete;
    MappedFrame& operator=(MappedFrame&&) = delete;

    ~MappedFrame() {
        if (is_mapped_) gst_video_frame_unmap(&frame_);
    }

    bool is_mapped() const { return is_mapped_; }

    const GstVideoFrame& frame() const { return frame_; }

  private:
    GstVideoFrame frame_{};
    bool is_mapped_ = false;
};

inline ColourCode colour_code(const GstVideoColorimetry& colours) {
    ColourCode code{.is_full_range = colours.range == GST_VIDEO_COLOR_RANGE_0_255};
    if (colours.matrix == GST_VIDEO_COLOR_MATRIX_BT709) code.matrix = ColourCode::Matrix::bt709;
    if (colours.matrix == GST_VIDEO_COLOR_MATRIX_BT2020) code.matrix = ColourCode::Matrix::bt2020;
    return code;
}

}  // namespace vitrine::player
