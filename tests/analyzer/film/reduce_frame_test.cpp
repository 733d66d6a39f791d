#include "analyzer/film/reduce_frame.hpp"

#include "base/media/gst_ptr.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

// A frame of one colour in one format, held in memory of its own.
class PlainFrame {
  public:
    PlainFrame(GstVideoFormat format, int width, int height, const char* colorimetry,
               std::array<int, 3> yuv) {
        start_gstreamer();
        gst_video_info_set_format(&info_, format, static_cast<guint>(width), static_cast<guint>(height));
        gst_video_colorimetry_from_string(&info_.colorimetry, colorimetry);
        buffer_ = gst_buffer_new_allocate(nullptr, info_.size, nullptr);
        REQUIRE(gst_video_frame_map(&frame_, &info_, buffer_, GST_MAP_READWRITE));
        for (guint i = 0; i < GST_VIDEO_FRAME_N_COMPONENTS(&frame_); ++i)
            fill(i, yuv[i]);
    }

    PlainFrame(const PlainFrame&) = delete;
    PlainFrame& operator=(const PlainFrame&) = delete;

    ~PlainFrame() {
        gst_video_frame_unmap(&frame_);
        gst_buffer_unref(buffer_);
    }

    const GstVideoFrame& get() const { return frame_; }

  private:
    void fill(guint component, int value) {
        auto* first = static_cast<std::uint8_t*>(GST_VIDEO_FRAME_COMP_DATA(&frame_, component));
        const bool wide = GST_VIDEO_FRAME_COMP_DEPTH(&frame_, component) > 8;
        for (int y = 0; y < GST_VIDEO_FRAME_COMP_HEIGHT(&frame_, component); ++y)
            for (int x = 0; x < GST_VIDEO_FRAME_COMP_WIDTH(&frame_, component); ++x) {
                auto* at = first + y * GST_VIDEO_FRAME_COMP_STRIDE(&frame_, component) +
                           x * GST_VIDEO_FRAME_COMP_PSTRIDE(&frame_, component);
                at[0] = static_cast<std::uint8_t>(wide ? value * 4 & 255 : value);
                if (wide) at[1] = static_cast<std::uint8_t>(value * 4 >> 8);
            }
    }

    GstVideoInfo info_{};
    GstBuffer* buffer_ = nullptr;
    GstVideoFrame frame_{};
};

void check_colour(const PlainFrame& frame, const cv::Vec3b& bgr) {
    const cv::Mat small = reduce_frame(frame.get(), {32, 18});
    REQUIRE(small.size() == cv::Size(32, 18));
    constexpr int tolerance = 2;
    for (int i = 0; i < 3; ++i)
        for (const cv::Point at : {cv::Point(0, 0), cv::Point(31, 17)})
            CHECK(std::abs(small.at<cv::Vec3b>(at)[i] - bgr[i]) <= tolerance);
}

}  // namespace

TEST_CASE("red is red in every matrix, range, depth and chroma layout") {
    const cv::Vec3b red(0, 0, 255);
    check_colour({GST_VIDEO_FORMAT_I420, 1280, 720, "bt709", {63, 102, 240}}, red);
    check_colour({GST_VIDEO_FORMAT_I420, 640, 360, "bt601", {81, 90, 240}}, red);
    check_colour({GST_VIDEO_FORMAT_Y42B, 641, 361, "bt601", {81, 90, 240}}, red);
    check_colour({GST_VIDEO_FORMAT_Y444, 401, 225, "bt601", {81, 90, 240}}, red);
    check_colour({GST_VIDEO_FORMAT_NV12, 333, 187, "bt601", {81, 90, 240}}, red);
    check_colour({GST_VIDEO_FORMAT_I420_10LE, 640, 360, "bt709", {63, 102, 240}}, red);
    check_colour({GST_VIDEO_FORMAT_I420, 320, 180, "1:4:5:1", {76, 85, 255}}, red);  // full range, JPEG's
}

TEST_CASE("white and black reach the ends in limited and in full range") {
    check_colour({GST_VIDEO_FORMAT_I420, 640, 360, "bt709", {235, 128, 128}}, {255, 255, 255});
    check_colour({GST_VIDEO_FORMAT_I420, 640, 360, "bt709", {16, 128, 128}}, {0, 0, 0});
    check_colour({GST_VIDEO_FORMAT_GRAY8, 640, 360, "1:4:5:1", {255, 0, 0}}, {255, 255, 255});
}

TEST_CASE("a frame of its own size keeps its pixels") {
    check_colour({GST_VIDEO_FORMAT_I420, 32, 18, "bt601", {128, 128, 128}}, {130, 130, 130});
}
