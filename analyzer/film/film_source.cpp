#include "analyzer/film/film_source.hpp"

#include "analyzer/film/reduce_frame.hpp"
#include "base/media/completeness.hpp"

#include <fmt/format.h>
#include <gst/tag/tag.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::analyzer {

namespace {

using std::chrono::nanoseconds;

constexpr int frames_ahead = 4;     // decoded while the caller works on an earlier one
constexpr int decoder_threads = 2;  // watch starts a child for every two cores

// Tells the decoder that frames may have gaps between their rows, which appsink 1.22 does not tell: else the
// decoder copies every frame.
GstPadProbeReturn welcome_gaps(GstPad*, GstPadProbeInfo* info, gpointer) {
    GstQuery* query = gst_pad_probe_info_get_query(info);
    if (GST_QUERY_TYPE(query) != GST_QUERY_ALLOCATION) return GST_PAD_PROBE_OK;
    gst_query_add_allocation_meta(query, GST_VIDEO_META_API_TYPE, nullptr);
    GstCaps* caps = nullptr;  // lent by the query
    gst_query_parse_allocation(query, &caps, nullptr);
    GstVideoInfo frame;
    if (caps && gst_video_info_from_caps(&frame, caps))
        gst_query_add_allocation_pool(query, nullptr, static_cast<guint>(GST_VIDEO_INFO_SIZE(&frame)), 1, 0);
    return GST_PAD_PROBE_HANDLED;
}

GstPtr<GstElement> appsink_tail() {
    start_gstreamer();
    return make_bin(fmt::format("videoconvert ! appsink name=sink sync=false qos=false max-buffers={} "
                                "caps=\"video/x-raw,format={}\"",
                                frames_ahead, reducible_formats)
                        .c_str());
}

GstPtr<GstElement> sink_in(GstElement* tail) {
    GstPtr<GstElement> sink(gst_bin_get_by_name(GST_BIN(tail), "sink"));
    const GstPtr<GstPad> pad(gst_element_get_static_pad(sink.get(), "sink"));
    gst_pad_add_probe(pad.get(), GST_PAD_PROBE_TYPE_QUERY_DOWNSTREAM, welcome_gaps, nullptr, nullptr);
    return sink;
}

// The rotation that the film's tags ask for; they lie on the pad once a frame has passed it.
GstVideoOrientationMethod orientation_at(GstElement* sink) {
    const GstPtr<GstPad> pad(gst_element_get_static_pad(sink, "sink"));
    auto method = GST_VIDEO_ORIENTATION_IDENTITY;
    for (guint i = 0;; ++i) {
        const GstPtr<GstEvent> event(gst_pad_get_sticky_event(pad.get(), GST_EVENT_TAG, i));
        if (!event) return method;
        GstTagList* tags = nullptr;  // lent by the event
        gst_event_parse_tag(event.get(), &tags);
        gst_video_orientation_from_tag(tags, &method);
    }
}

bool is_on_its_side(GstVideoOrientationMethod turn) {
    return turn == GST_VIDEO_ORIENTATION_90R || turn == GST_VIDEO_ORIENTATION_90L ||
           turn == GST_VIDEO_ORIENTATION_UL_LR || turn == GST_VIDEO_ORIENTATION_UR_LL;
}

cv::Mat turned(const cv::Mat& picture, GstVideoOrientationMethod turn) {
    cv::Mat out;
    switch (turn) {
    case GST_VIDEO_ORIENTATION_90R:
        cv::rotate(picture, out, cv::ROTATE_90_CLOCKWISE);
        break;
    case GST_VIDEO_ORIENTATION_180:
        cv::rotate(picture, out, cv::ROTATE_180);
        break;
    case GST_VIDEO_ORIENTATION_90L:
        cv::rotate(picture, out, cv::ROTATE_90_COUNTERCLOCKWISE);
        break;
    case GST_VIDEO_ORIENTATION_HORIZ:
        cv::flip(picture, out, 1);
        break;
    case GST_VIDEO_ORIENTATION_VERT:
        cv::flip(picture, out, 0);
        break;
    case GST_VIDEO_ORIENTATION_UL_LR:
        cv::transpose(picture, out);
        break;
    case GST_VIDEO_ORIENTATION_UR_LL:
        cv::rotate(picture, out, cv::ROTATE_180);
        cv::transpose(out, out);
        break;
    default:
        return picture;
    }
    return out;
}

// Gives the size, px, of the video with square pixels and with no side longer than `longest`.
cv::Size reduced_size(const GstVideoInfo& video, int longest) {
    const double aspect = static_cast<double>(std::max(video.par_n, 1)) / std::max(video.par_d, 1);
    const double width = video.width * aspect;
    const double scale = std::min(1.0, longest / std::max<double>(width, video.height));
    const auto whole = [](double length) { return std::max(1, static_cast<int>(std::lround(length))); };
    return {whole(width * scale), whole(video.height * scale)};
}

// A mapped frame of a sample.
class MappedFrame {
  public:
    explicit MappedFrame(GstSample* sample) {
        GstVideoInfo info;
        if (!gst_video_info_from_caps(&info, gst_sample_get_caps(sample)) ||
            !gst_video_frame_map(&frame_, &info, gst_sample_get_buffer(sample), GST_MAP_READ))
            throw MediaError(MediaState::failed, "the film cannot be read: a frame of unknown layout");
    }

    MappedFrame(const MappedFrame&) = delete;
    MappedFrame& operator=(const MappedFrame&) = delete;

    ~MappedFrame() { gst_video_frame_unmap(&frame_); }

    const GstVideoFrame& get() const { return frame_; }

  private:
    GstVideoFrame frame_{};
};

}  // namespace

FilmSource::FilmSource(const std::string& path, int analysis_size, Colour background)
    : chain_(path, appsink_tail(), {.max_threads = decoder_threads}),
      sink_(sink_in(chain_.tail())),
      background_(background) {
    require_complete(path, chain_.format());
    extent_known_ = file_extent(path, chain_.format()).declared > 0;
    chain_.preroll();
    read_geometry(analysis_size);
    info_.kind = MediaKind::film;
    info_.duration = chain_.duration();
    gst_element_set_state(chain_.pipeline(), GST_STATE_PLAYING);
}

void FilmSource::read_geometry(int analysis_size) {
    const GstPtr<GstSample> first(gst_app_sink_try_pull_preroll(GST_APP_SINK(sink_.get()), 0));
    if (!first) throw MediaError(MediaState::failed, "the film cannot be read: it holds no picture");
    GstVideoInfo video;
    if (!gst_video_info_from_caps(&video, gst_sample_get_caps(first.get())))
        throw MediaError(MediaState::failed, "the film cannot be read: a frame of unknown layout");
    turn_ = orientation_at(sink_.get());
    tones_ = ToneMap::of(video.colorimetry);
    info_.colours = video.colorimetry;
    info_.turn = turn_;
    coded_size_ = reduced_size(video, analysis_size);
    finer_size_ = reduced_size(video, 2 * analysis_size);
    const cv::Size whole = reduced_size(video, std::numeric_limits<int>::max());
    info_.width = whole.width;
    info_.height = whole.height;
    if (is_on_its_side(turn_)) std::swap(info_.width, info_.height);
}

std::optional<FilmFrame> FilmSource::next() {
    while (!ended_) {
        const std::shared_ptr<GstSample> sample = chain_.pull(GST_APP_SINK(sink_.get()));
        if (!sample) break;
        const nanoseconds time = times_.of(sample.get());
        if (time <= last_) continue;  // each moment once: broken files repeat time stamps
        last_ = time;
        return frame_of(sample, time);
    }
    if (!ended_) finish();
    return std::nullopt;
}

cv::Mat FilmSource::picture_of(GstSample* sample, cv::Size coded) const {
    const MappedFrame frame(sample);
    cv::Mat picture = reduce_frame(frame.get(), coded, background_);  // rows without gaps
    if (tones_) tones_->apply({picture.data, picture.total() * picture.elemSize()}, 3, true);
    return turned(picture, turn_);
}

FilmFrame FilmSource::frame_of(const std::shared_ptr<GstSample>& sample, nanoseconds time) const {
    FilmFrame frame{.picture = picture_of(sample.get(), coded_size_), .time = time, .finer = {}};
    if (finer_size_ != coded_size_)
        frame.finer = [this, sample] { return picture_of(sample.get(), finer_size_); };
    return frame;
}

void FilmSource::finish() {
    ended_ = true;
    if (last_ < nanoseconds{0})
        throw MediaError(MediaState::failed, "the film cannot be read: it holds no picture");
    const nanoseconds end = times_.end();
    constexpr double complete = 0.9;  // sound may go on for a while
    const double share = info_.duration.count() > 0
                             ? static_cast<double>(end.count()) / static_cast<double>(info_.duration.count())
                             : 1;
    if (!extent_known_ && share < complete && info_.duration - end > std::chrono::seconds(2))
        throw MediaError(
            MediaState::waiting,
            fmt::format("the copy is not complete: the film ends at {:.0f} % of its length", 100 * share));
    info_.duration = end;
    gst_element_set_state(chain_.pipeline(), GST_STATE_READY);
}

}  // namespace vitrine::analyzer
