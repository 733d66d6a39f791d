#include "base/media/sound_chain.hpp"

#include "base/media/decoder_table.hpp"
#include "base/media/film_elements.hpp"

#include <initializer_list>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace vitrine {

namespace {

constexpr const char* without_sound = "vitrine-without-sound";  // marks our own errors

void post_lack(GstElement* element, const std::string& text) {
    post_error(element, GST_STREAM_ERROR_CODEC_NOT_FOUND, text, without_sound);
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
        const GstPtr<GstCaps> caps = stream_caps(pad);
        if (linked || !caps) return;
        const std::string_view name = gst_structure_get_name(gst_caps_get_structure(caps.get(), 0));
        if (!name.starts_with("audio/")) return;
        has_sound = true;
        if (const auto row = sound_decoder_for(caps.get())) link(pad, *row);
    }

    void link(GstPad* pad, const DecoderRow& row) {
        GstElement* last = tail;
        const char* const decoder = form == Form::raw ? row.decoder : nullptr;
        for (const char* factory :
             {decoder, row.parser}) {  // the last first, so that data finds a linked element
            if (!factory) continue;
            GstElement* const made = add_element(bin, factory);
            if (!gst_element_link(made, last) || !gst_element_sync_state_with_parent(made))
                throw std::runtime_error("its sound cannot be decoded");
            last = made;
        }
        const GstPtr<GstPad> sink(gst_element_get_static_pad(last, "sink"));
        linked = gst_pad_link(pad, sink.get()) == GST_PAD_LINK_OK;
    }

    GstBin* bin = nullptr;  // both are lent by the chain, which outlives the links
    GstElement* tail = nullptr;
    Form form = Form::raw;
    bool linked = false;
    bool has_sound = false;
};

SoundChain::SoundChain(const std::string& path, GstPtr<GstElement> tail, Form form)
    : tail_(std::move(tail)), links_(std::make_unique<Links>()) {
    FilmBegin begin = begin_film(path);
    format_ = begin.format;
    pipeline_ = std::move(begin.pipeline);
    bus_.reset(gst_element_get_bus(pipeline_.get()));
    gst_bin_add(GST_BIN(pipeline_.get()), tail_.get());
    links_->bin = GST_BIN(pipeline_.get());
    links_->tail = tail_.get();
    links_->form = form;
    if (begin.demuxer == nullptr) {
        post_lack(pipeline_.get(), "the film has no sound");
        return;
    }
    g_signal_connect(begin.demuxer, "pad-added", G_CALLBACK(Links::pad_added), links_.get());
    g_signal_connect(begin.demuxer, "no-more-pads", G_CALLBACK(Links::no_more_pads), links_.get());
}

SoundChain::~SoundChain() {
    gst_element_set_state(pipeline_.get(), GST_STATE_NULL);  // ends every thread
}

bool lacks_sound(GstMessage* error) {
    return is_marked(error, without_sound);
}

std::string text_of(GstMessage* error) {
    GError* raw = nullptr;
    gst_message_parse_error(error, &raw, nullptr);
    const GstPtr<GError> owned(raw);
    return raw->message;
}

}  // namespace vitrine
