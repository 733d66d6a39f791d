#include "base/media/animation_source.hpp"

#include "base/media/completeness.hpp"
#include "base/media/film_elements.hpp"
#include "base/media/png_animation.hpp"
#include "base/state/media_error.hpp"

#include <gst/app/gstappsrc.h>

#include <exception>
#include <memory>
#include <utility>

namespace vitrine {

namespace {

/// The animation behind a source element, which owns it. The element calls it from one thread at a time.
class PlayedAnimation {
  public:
    PlayedAnimation(std::string path, MediaFormat format, const char* mark)
        : path_(std::move(path)),
          format_(format),
          mark_(mark),
          reader_(open_animation(path_, format_)),
          info_(reader_->info()) {}

    const AnimationInfo& info() const { return info_; }

    /// Gives the next picture, or says that there is none.
    static void on_need(GstAppSrc* source, guint, gpointer self) {
        try {
            static_cast<PlayedAnimation*>(self)->give(source);
        } catch (const MediaError& error) {
            auto* const animation = static_cast<PlayedAnimation*>(self);
            post_error(GST_ELEMENT(source), GST_STREAM_ERROR_FAILED, error.what(), animation->mark_);
            gst_app_src_end_of_stream(source);
        } catch (const std::exception&) {  // no memory
            auto* const animation = static_cast<PlayedAnimation*>(self);
            post_error(GST_ELEMENT(source), GST_STREAM_ERROR_FAILED, "the film cannot be played",
                       animation->mark_);
            gst_app_src_end_of_stream(source);
        }
    }

    /// Goes to the picture that is shown at a time.
    static gboolean on_seek(GstAppSrc*, guint64 time, gpointer self) {
        try {
            static_cast<PlayedAnimation*>(self)->go_to(std::chrono::nanoseconds(time));
            return TRUE;
        } catch (const std::exception&) {  // the file has gone meanwhile
            return FALSE;
        }
    }

    static void destroy(gpointer self) { delete static_cast<PlayedAnimation*>(self); }

  private:
    void give(GstAppSrc* source) {
        if (wanted_ >= info_.durations.size()) {
            gst_app_src_end_of_stream(source);
            return;
        }
        std::vector<std::byte> pixels;
        while (read_ <= wanted_) {
            pixels = reader_->next();
            if (read_++ < wanted_) time_ += info_.durations[read_ - 1];
        }
        GstBuffer* const buffer = gst_buffer_new_allocate(nullptr, pixels.size(), nullptr);
        if (buffer == nullptr) throw std::bad_alloc();
        gst_buffer_fill(buffer, 0, pixels.data(), pixels.size());
        const std::chrono::nanoseconds duration = info_.durations[wanted_++];
        GST_BUFFER_PTS(buffer) = static_cast<GstClockTime>(time_.count());
        GST_BUFFER_DURATION(buffer) = static_cast<GstClockTime>(duration.count());
        time_ += duration;
        gst_app_src_push_buffer(source, buffer);  // takes the buffer
    }

    void go_to(std::chrono::nanoseconds time) {
        std::size_t picture = 0;
        for (std::chrono::nanoseconds end{0}; picture + 1 < info_.durations.size(); ++picture) {
            end += info_.durations[picture];
            if (time < end) break;
        }
        if (picture < read_) {  // it can only be read from its begin
            if (read_ > 0) reader_ = open_animation(path_, format_);
            read_ = 0;
            time_ = {};
        }
        wanted_ = picture;
    }

    std::string path_;
    MediaFormat format_;
    const char* mark_;
    std::unique_ptr<AnimationReader> reader_;
    AnimationInfo info_;
    std::size_t read_ = 0;              // pictures that the reader has given
    std::size_t wanted_ = 0;            // the picture that comes next
    std::chrono::nanoseconds time_{0};  // begin of the picture that the reader gives next
};

}  // namespace

std::unique_ptr<AnimationReader> open_animation(const std::string& path, MediaFormat format,
                                                Colour background) {
    require_complete(path, format);
    if (format == MediaFormat::animated_png) return std::make_unique<PngAnimation>(path, background);
    return open_vips_animation(path, format, background);
}

GstElement* add_animation_source(GstBin* bin, const std::string& path, MediaFormat format, const char* mark) {
    auto animation = std::make_unique<PlayedAnimation>(path, format, mark);
    GstElement* const element = add_element(bin, "appsrc");
    const AnimationInfo& info = animation->info();
    const GstPtr<GstCaps> caps(gst_caps_new_simple(
        "video/x-raw", "format", G_TYPE_STRING, "RGBx", "width", G_TYPE_INT, info.width, "height", G_TYPE_INT,
        info.height, "framerate", GST_TYPE_FRACTION, 0, 1, "pixel-aspect-ratio", GST_TYPE_FRACTION, 1, 1,
        "interlace-mode", G_TYPE_STRING, "progressive", nullptr));
    GstAppSrc* const source = GST_APP_SRC(element);
    g_object_set(source, "format", GST_FORMAT_TIME, "max-buffers", guint64{1}, "max-bytes", guint64{0},
                 nullptr);
    gst_app_src_set_stream_type(source, GST_APP_STREAM_TYPE_SEEKABLE);
    gst_app_src_set_caps(source, caps.get());
    gst_app_src_set_duration(source, static_cast<GstClockTime>(info.duration().count()));
    GstAppSrcCallbacks calls{};
    calls.need_data = &PlayedAnimation::on_need;
    calls.seek_data = &PlayedAnimation::on_seek;
    gst_app_src_set_callbacks(source, &calls, animation.release(), &PlayedAnimation::destroy);
    return element;
}

}  // namespace vitrine
