#include "base/media/film_size.hpp"

#include "base/media/coded_size.hpp"
#include "base/media/film_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace vitrine {

namespace {

constexpr std::int64_t max_growth = 4;               // times the pixels of the first picture
constexpr std::int64_t usual_pixels = 1920 * 1088L;  // a film of any size may grow to this

std::int64_t pixels_of(const CodedSize& size) {
    return std::int64_t{size.width} * size.height;
}

bool is_too_large(const CodedSize& size) {
    return size.width > max_film_side || size.height > max_film_side || pixels_of(size) > max_film_pixels;
}

/// @param first  pixels of the film's first picture
bool is_refused(const CodedSize& size, std::int64_t first) {
    return is_too_large(size) || pixels_of(size) > std::max(max_growth * first, usual_pixels);
}

/// @pre the picture is refused
std::string why_refused(const CodedSize& size) {
    if (is_too_large(size))
        return fmt::format(
            "the film is too large: {} x {} px; up to {} megapixels and {} px a side are shown", size.width,
            size.height, max_film_pixels / 1'000'000, max_film_side);
    return fmt::format("a picture in its midst is far larger than its first: {} x {} px", size.width,
                       size.height);
}

/// The probe of one pad; its data come in one thread.
class SizeLimit {
  public:
    explicit SizeLimit(const char* mark) : mark_(mark) {}

    static GstPadProbeReturn probe(GstPad* pad, GstPadProbeInfo* info, gpointer self) {
        auto* limit = static_cast<SizeLimit*>(self);
        if ((GST_PAD_PROBE_INFO_TYPE(info) & GST_PAD_PROBE_TYPE_EVENT_DOWNSTREAM) != 0)
            return limit->pass_event(pad, gst_pad_probe_info_get_event(info));
        if ((GST_PAD_PROBE_INFO_TYPE(info) & GST_PAD_PROBE_TYPE_BUFFER_LIST) != 0)
            limit->look_at_list(pad, gst_pad_probe_info_get_buffer_list(info));
        else
            limit->look_at_picture(pad, gst_pad_probe_info_get_buffer(info));
        if (!limit->is_exceeded_) return GST_PAD_PROBE_OK;
        GST_PAD_PROBE_INFO_FLOW_RETURN(info) = GST_FLOW_ERROR;  // the elements before this one stop, too
        gst_mini_object_unref(static_cast<GstMiniObject*>(GST_PAD_PROBE_INFO_DATA(info)));
        return GST_PAD_PROBE_HANDLED;
    }

    static void destroy(gpointer self) { delete static_cast<SizeLimit*>(self); }

  private:
    GstPadProbeReturn pass_event(GstPad* pad, GstEvent* event) {
        if (GST_EVENT_TYPE(event) != GST_EVENT_CAPS) return GST_PAD_PROBE_OK;
        GstCaps* caps = nullptr;  // lent by the event
        gst_event_parse_caps(event, &caps);
        const GstStructure* stream = gst_caps_get_structure(caps, 0);
        codec_ = gst_structure_get_name_id(stream);
        CodedSize size;
        if (gst_structure_get_int(stream, "width", &size.width) &&
            gst_structure_get_int(stream, "height", &size.height))
            require(pad, size);
        return is_exceeded_ ? GST_PAD_PROBE_DROP : GST_PAD_PROBE_OK;
    }

    void look_at_list(GstPad* pad, GstBufferList* list) {
        for (guint i = 0; i < gst_buffer_list_length(list); ++i)
            look_at_picture(pad, gst_buffer_list_get(list, i));
    }

    void look_at_picture(GstPad* pad, GstBuffer* buffer) {
        static const GQuark vp8 = g_quark_from_static_string("video/x-vp8");
        static const GQuark vp9 = g_quark_from_static_string("video/x-vp9");
        if (is_exceeded_ || (codec_ != vp8 && codec_ != vp9)) return;
        GstMapInfo bytes;
        if (!gst_buffer_map(buffer, &bytes, GST_MAP_READ)) return;
        const auto size = coded_size(g_quark_to_string(codec_), {bytes.data, bytes.size});
        gst_buffer_unmap(buffer, &bytes);
        if (size) require(pad, *size);
    }

    void require(GstPad* pad, const CodedSize& size) {
        if (is_exceeded_) return;
        if (first_ == 0) first_ = pixels_of(size);
        if (!is_refused(size, first_)) return;
        is_exceeded_ = true;
        const GstPtr<GstElement> element(gst_pad_get_parent_element(pad));
        if (!element) return;
        try {
            post_error(element.get(), GST_STREAM_ERROR_NOT_IMPLEMENTED, why_refused(size), mark_);
        } catch (const std::exception&) {  // no memory: the elements before this one post an error of theirs
        }
    }

    const char* mark_;        // a literal
    GQuark codec_ = 0;        // the name of the stream's caps
    std::int64_t first_ = 0;  // pixels of the first picture
    bool is_exceeded_ = false;
};

}  // namespace

void limit_picture_size(GstPad* pad, const char* mark) {
    gst_pad_add_probe(pad, GST_PAD_PROBE_TYPE_DATA_DOWNSTREAM, SizeLimit::probe, new SizeLimit(mark),
                      SizeLimit::destroy);
}

}  // namespace vitrine
