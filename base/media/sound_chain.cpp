#include "base/media/sound_chain.hpp"

#include "base/catalogue/media_error.hpp"
#include "base/media/decoder_table.hpp"

#include <initializer_list>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace vitrine {

namespace {

constexpr const char* without_sound = "vitrine-without-sound";  // the details of our own errors

/// Errors are told by messages, for exceptions must not cross GStreamer's threads.
void post_lack(GstElement* element, const std::string& text) {
    gst_element_message_full_with_details(element, GST_MESSAGE_ERROR, GST_STREAM_ERROR,
                                          GST_STREAM_ERROR_CODEC_NOT_FOUND, g_strdup(text.c_str()), nullptr,
                                          __FILE__, __func__, __LINE__,
                                          gst_structure_new_empty(without_sound));  // which it takes
}

}  // namespace

struct SoundChain::Links {
    static void pad_added(GstElement* demuxer, GstPad* pad, gpointer self) {
        try {
            static_cast<Links*>(self)->add_stream(pad);
        } catch (const std::exception& error) {
            post_lack(demuxer, error.what());
        }
    }

    static void no_more_pads(GstElement* demuxer, gpointer self) {
        const auto* links = static_cast<const Links*>(self);
        if (links->linked) return;
        post_lack(demuxer, links->has_sound ? "its sound is coded in a way that is not decoded here"
                                            : "the film has no sound");
    }

    void add_stream(GstPad* pad) {
        GstPtr<GstCaps> caps(gst_pad_get_current_caps(pad));
        if (!caps) caps.reset(gst_pad_query_caps(pad, nullptr));
        if (linked || !caps || gst_caps_is_empty(caps.get()) || gst_caps_is_any(caps.get())) return;
        const std::string_view name = gst_structure_get_name(gst_caps_get_structure(caps.get(), 0));
        if (!name.starts_with("audio/")) return;
        has_sound = true;
        if (const auto row = sound_decoder_for(caps.get())) link(pad, *row);
    }

    void link(GstPad* pad, const DecoderRow& row) {
        GstElement* last = tail;
        const char* const decoder = form == Form::raw ? row.decoder : nullptr;
        for (const char* factory : {decoder, row.parser}) {  // from the back, so that data finds its way
            if (!factory) continue;
            const GstPtr<GstElement> made = make_element(factory);
            gst_bin_add(bin, made.get());
            if (!gst_element_link(made.get(), last) || !gst_element_sync_state_with_parent(made.get()))
                throw std::runtime_error("its sound cannot be decoded");
            last = made.get();
        }
        const GstPtr<GstPad> sink(gst_element_get_static_pad(last, "sink"));
        linked = gst_pad_link(pad, sink.get()) == GST_PAD_LINK_OK;
    }

    GstBin* bin = nullptr;  // both lent by the chain, which outlives the links
    GstElement* tail = nullptr;
    Form form = Form::raw;
    bool linked = false;
    bool has_sound = false;
};

SoundChain::SoundChain(const std::string& path, GstPtr<GstElement> tail, Form form)
    : format_(media_format(path)), tail_(std::move(tail)), links_(std::make_unique<Links>()) {
    if (kind_of(format_) != MediaKind::video)
        throw MediaError(MediaState::unsupported, "this is a picture, not a film");
    start_gstreamer();
    pipeline_.reset(gst_pipeline_new(nullptr));
    gst_object_ref_sink(pipeline_.get());
    bus_.reset(gst_element_get_bus(pipeline_.get()));
    const GstPtr<GstElement> source = make_element("filesrc");
    const GstPtr<GstElement> demuxer = make_element(demuxer_for(format_));
    for (GstElement* element : {source.get(), demuxer.get(), tail_.get()})
        gst_bin_add(GST_BIN(pipeline_.get()), element);
    g_object_set(source.get(), "location", path.c_str(), nullptr);
    if (!gst_element_link(source.get(), demuxer.get()))
        throw std::runtime_error("a film's file cannot be linked to its demuxer");
    links_->bin = GST_BIN(pipeline_.get());
    links_->tail = tail_.get();
    links_->form = form;
    g_signal_connect(demuxer.get(), "pad-added", G_CALLBACK(Links::pad_added), links_.get());
    g_signal_connect(demuxer.get(), "no-more-pads", G_CALLBACK(Links::no_more_pads), links_.get());
}

SoundChain::~SoundChain() {
    gst_element_set_state(pipeline_.get(), GST_STATE_NULL);  // ends every thread
}

bool lacks_sound(GstMessage* error) {
    const GstStructure* details = nullptr;  // lent by the message
    gst_message_parse_error_details(error, &details);
    return details && gst_structure_has_name(details, without_sound);
}

std::string text_of(GstMessage* error) {
    GError* raw = nullptr;
    gst_message_parse_error(error, &raw, nullptr);
    const GstPtr<GError> owned(raw);
    return raw->message;
}

}  // namespace vitrine
