#include "base/media/film_elements.hpp"

#include "base/media/decoder_table.hpp"
#include "base/state/media_error.hpp"

#include <stdexcept>

namespace vitrine {

FilmBegin begin_film(const std::string& path) {
    FilmBegin begin{.pipeline = {}, .format = media_format(path)};
    if (kind_of(begin.format) != MediaKind::film)
        throw MediaError(MediaState::unsupported, "this is a picture, not a film");
    start_gstreamer();
    begin.pipeline.reset(gst_pipeline_new(nullptr));
    gst_object_ref_sink(begin.pipeline.get());
    if (is_animation(begin.format)) return begin;
    GstBin* const bin = GST_BIN(begin.pipeline.get());
    GstElement* const source = add_element(bin, "filesrc");
    g_object_set(source, "location", path.c_str(), nullptr);
    begin.demuxer = add_element(bin, demuxer_for(begin.format));
    if (!gst_element_link(source, begin.demuxer))
        throw std::runtime_error("a film's file cannot be linked to its demuxer");
    return begin;
}

GstElement* add_element(GstBin* bin, const char* factory) {
    const GstPtr<GstElement> element = make_element(factory);
    GstElement* const held = element.get();  // owned by the bin
    gst_bin_add(bin, held);
    return held;
}

GstPtr<GstCaps> stream_caps(GstPad* pad) {
    GstPtr<GstCaps> caps(gst_pad_get_current_caps(pad));
    if (!caps) caps.reset(gst_pad_query_caps(pad, nullptr));
    if (caps && (gst_caps_is_empty(caps.get()) || gst_caps_is_any(caps.get()))) caps.reset();
    return caps;
}

void post_error(GstElement* element, GstStreamError code, const std::string& text, const char* mark) {
    gst_element_message_full_with_details(element, GST_MESSAGE_ERROR, GST_STREAM_ERROR, code,
                                          g_strdup(text.c_str()), nullptr, __FILE__, __func__, __LINE__,
                                          gst_structure_new_empty(mark));  // the message owns it
}

bool is_marked(GstMessage* error, const char* mark) {
    const GstStructure* details = nullptr;  // lent by the message
    gst_message_parse_error_details(error, &details);
    return details && gst_structure_has_name(details, mark);
}

}  // namespace vitrine
