// decodebin and parsebin are not used, because they choose among all plugins of the machine by the file's
// content, start a thread and a queue for every stream, decode sound that nobody hears, and did not end on
// some odd files. The video stream of a film needs four elements, and a table of a dozen rows lists them.

#include "base/media/decode_chain.hpp"

#include "base/media/animation_source.hpp"
#include "base/media/decoder_table.hpp"
#include "base/media/film_elements.hpp"
#include "base/media/film_size.hpp"
#include "base/system/log.hpp"
#include "base/system/stall.hpp"

#include <fmt/format.h>
#include <gst/pbutils/pbutils.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <string_view>
#include <utility>

namespace vitrine {

// The data of the demuxer's callbacks, which run in its thread.
struct DecodeChain::Links {
    GstBin* bin = nullptr;              // the pipeline, outlives the links
    GstElement* deinterlace = nullptr;  // the decoder is linked to it; owned by the bin
    DecodeOptions options;
    bool linked = false;
    bool has_sound = false;
    bool has_secret = false;
    std::string unknown_codec;

    static void pad_added(GstElement* demuxer, GstPad* pad, gpointer self);
    static void no_more_pads(GstElement* demuxer, gpointer self);
    void add_stream(GstElement* demuxer, GstPad* pad);
    void link_decoder(GstPad* pad, const DecoderRow& row);
    std::string why_nothing() const;
};

namespace {

constexpr const char* encrypted = "the film is encrypted; bring a copy without protection";
constexpr const char* not_linkable = "the film is damaged: its pictures cannot be decoded";

constexpr std::chrono::seconds max_stall{20};
constexpr GstClockTime look_interval = GST_SECOND;

constexpr const char* own_words = "vitrine-reason";  // marks our own messages; their text is for the operator

void post_own(GstElement* element, GstStreamError code, const std::string& text) {
    post_error(element, code, text, own_words);
}

// The cause that a source element gives for a failed call, in the words of the system: "Input/output error".
std::string cause_in(const std::string& debug) {
    constexpr std::string_view mark = "system error: ";
    const std::size_t at = debug.rfind(mark);
    return at == std::string::npos ? "" : ": " + debug.substr(at + mark.size());
}

bool is_from_source(GstMessage* message) {
    return GST_IS_ELEMENT(GST_MESSAGE_SRC(message)) &&
           GST_OBJECT_FLAG_IS_SET(GST_MESSAGE_SRC(message), GST_ELEMENT_FLAG_SOURCE);
}

// Plain words for the libraries' errors, for the person who put the film there.
MediaError in_plain_words(const GError* error) {
    if (error->domain == GST_RESOURCE_ERROR) return {MediaState::failed, "the film's file cannot be read"};
    if (error->domain != GST_STREAM_ERROR) return {MediaState::failed, "the film cannot be played"};
    switch (error->code) {
    case GST_STREAM_ERROR_CODEC_NOT_FOUND:
        return {MediaState::unsupported, "the film's picture is coded in a way that is not decoded here; "
                                         "H.264 in MP4 plays everywhere"};
    case GST_STREAM_ERROR_DECRYPT:
    case GST_STREAM_ERROR_DECRYPT_NOKEY:
        return {MediaState::unsupported, encrypted};
    case GST_STREAM_ERROR_DECODE:
    case GST_STREAM_ERROR_FORMAT:
        return {MediaState::failed, "the film is damaged: its pictures cannot be decoded"};
    case GST_STREAM_ERROR_DEMUX:
    case GST_STREAM_ERROR_WRONG_TYPE:
    case GST_STREAM_ERROR_TYPE_NOT_FOUND:
        return {MediaState::failed, "the film is damaged: no pictures can be found in it"};
    default:
        return {MediaState::failed, "the film cannot be played"};
    }
}

// Each decoder has its own name for the number of threads; av1dec has none.
void limit_threads(GstElement* decoder, int threads) {
    for (const char* property : {"max-threads", "threads"})
        if (g_object_class_find_property(G_OBJECT_GET_CLASS(decoder), property))
            g_object_set(decoder, property, threads, nullptr);
}

void limit_pictures_at(GstElement* element) {
    const GstPtr<GstPad> sink(gst_element_get_static_pad(element, "sink"));
    limit_picture_size(sink.get(), own_words);
}

/// Names of codecs that GStreamer calls by their mark in the container.
constexpr std::array<std::pair<std::string_view, const char*>, 9> codecs_by_mark{{{"dav1", "Dolby Vision"},
                                                                                  {"dvh1", "Dolby Vision"},
                                                                                  {"dvhe", "Dolby Vision"},
                                                                                  {"dva1", "Dolby Vision"},
                                                                                  {"vvc1", "H.266"},
                                                                                  {"vvi1", "H.266"},
                                                                                  {"AVdh", "DNxHR"},
                                                                                  {"AVdn", "DNxHD"},
                                                                                  {"CFHD", "CineForm"}}};

std::string codec_name(const GstCaps* caps) {
    const GstPtr<gchar> description(gst_pb_utils_get_codec_description(caps));
    std::string_view name = description ? description.get() : "an unknown codec";
    for (const auto& [mark, codec] : codecs_by_mark)
        if (name.ends_with(mark)) return codec;
    constexpr std::string_view before_mark = "video/x-gst-fourcc-";
    if (name.starts_with(before_mark)) name.remove_prefix(before_mark.size());
    return std::string(name);
}

/// The caps of a stream that is encrypted, in MP4 and in WebM.
bool is_encrypted(std::string_view caps_name) {
    return caps_name == "application/x-cenc" || caps_name == "application/x-cbcs" ||
           caps_name == "application/x-webm-enc";
}

}  // namespace

void DecodeChain::Links::pad_added(GstElement* demuxer, GstPad* pad, gpointer self) {
    try {
        static_cast<Links*>(self)->add_stream(demuxer, pad);
    } catch (const std::exception& error) {
        post_own(demuxer, GST_STREAM_ERROR_FAILED, error.what());
    }
}

void DecodeChain::Links::no_more_pads(GstElement* demuxer, gpointer self) {
    const auto* links = static_cast<const Links*>(self);
    if (!links->linked) post_own(demuxer, GST_STREAM_ERROR_CODEC_NOT_FOUND, links->why_nothing());
}

void DecodeChain::Links::add_stream(GstElement* demuxer, GstPad* pad) {
    const GstPtr<GstCaps> caps = stream_caps(pad);
    if (linked || !caps) return;
    const std::string_view name = gst_structure_get_name(gst_caps_get_structure(caps.get(), 0));
    if (name.starts_with("audio/")) has_sound = true;
    if (is_encrypted(name)) has_secret = true;
    if (!name.starts_with("video/") && !name.starts_with("image/")) return;
    const auto row = decoder_for(caps.get());
    if (!row) {
        unknown_codec = codec_name(caps.get());
        return;
    }
    link_decoder(pad, *row);
    if (!linked) post_own(demuxer, GST_STREAM_ERROR_FAILED, not_linkable);
}

void DecodeChain::Links::link_decoder(GstPad* pad, const DecoderRow& row) {
    GstElement* last = deinterlace;
    for (const char* factory :
         {row.decoder, row.parser}) {  // the last first, so that data finds a linked element
        if (!factory) continue;
        const auto other = options.instead.find(factory);
        GstElement* element =
            add_element(bin, other == options.instead.end() ? factory : other->second.c_str());
        if (factory == row.decoder) {
            limit_threads(element, options.max_threads);
            limit_pictures_at(element);
        }
        if (!gst_element_link(element, last) || !gst_element_sync_state_with_parent(element)) return;
        last = element;
    }
    const GstPtr<GstPad> sink(gst_element_get_static_pad(last, "sink"));
    linked = gst_pad_link(pad, sink.get()) == GST_PAD_LINK_OK;
}

std::string DecodeChain::Links::why_nothing() const {
    if (!unknown_codec.empty())
        return fmt::format(
            "the film's picture is coded as {}, which is not decoded here; H.264 in MP4 plays everywhere",
            unknown_codec);
    if (has_secret) return encrypted;
    return has_sound ? "the file holds only sound" : "the file holds no video stream";
}

DecodeChain::DecodeChain(const std::string& path, GstPtr<GstElement> tail, DecodeOptions options)
    : tail_(std::move(tail)), links_(std::make_unique<Links>()) {
    FilmBegin begin = begin_film(path);
    format_ = begin.format;
    pipeline_ = std::move(begin.pipeline);
    bus_.reset(gst_element_get_bus(pipeline_.get()));
    GstBin* bin = GST_BIN(pipeline_.get());
    GstElement* deinterlace = add_element(bin, "deinterlace");
    gst_bin_add(bin, tail_.get());
    gst_util_set_object_arg(G_OBJECT(deinterlace), "fields", "top");  // one picture a frame, not one a field
    if (!gst_element_link(deinterlace, tail_.get()))
        throw std::runtime_error(
            "the tail of a decode chain cannot be linked: it needs a pad 'sink' for raw video");
    limit_pictures_at(deinterlace);  // some decoders alone know the size of their pictures
    links_->bin = bin;
    links_->deinterlace = deinterlace;
    links_->options = std::move(options);
    if (begin.demuxer == nullptr) {
        link_animation(path);
        return;
    }
    g_signal_connect(begin.demuxer, "pad-added", G_CALLBACK(Links::pad_added), links_.get());
    g_signal_connect(begin.demuxer, "no-more-pads", G_CALLBACK(Links::no_more_pads), links_.get());
}

void DecodeChain::link_animation(const std::string& path) {
    GstElement* const source = add_animation_source(links_->bin, path, format_, own_words);
    if (!gst_element_link(source, links_->deinterlace)) throw std::runtime_error(not_linkable);
}

/// A thread that hangs in a decoder cannot be ended. Its pipeline is left to it, with all that it uses, so
/// that whoever destroys this does not hang, too.
DecodeChain::~DecodeChain() {
    if (is_stuck_) {
        (void)pipeline_.release();
        (void)links_.release();
    }
    if (pipeline_) gst_element_set_state(pipeline_.get(), GST_STATE_NULL);  // ends every thread
}

MediaError DecodeChain::stuck(const char* reason) {
    is_stuck_ = true;
    return {MediaState::failed, reason};
}

void DecodeChain::preroll() {
    gst_element_set_state(pipeline_.get(), GST_STATE_PAUSED);  // a failure arrives as a message
    constexpr auto awaited = static_cast<GstMessageType>(GST_MESSAGE_ERROR | GST_MESSAGE_ASYNC_DONE);
    GstPtr<GstMessage> message;
    for (Stall stall(max_stall); !message && !stall.is_hanging();)
        message.reset(gst_bus_timed_pop_filtered(bus_.get(), look_interval, awaited));
    if (!message) throw stuck("the film does not start: no picture comes");
    if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_ERROR) throw media_error(message.get());
}

GstPtr<GstSample> DecodeChain::pull(GstAppSink* sink) {
    for (Stall stall(max_stall); !stall.is_hanging();) {
        if (GstPtr<GstSample> sample{gst_app_sink_try_pull_sample(sink, look_interval)}) return sample;
        throw_pending_error();
        if (gst_app_sink_is_eos(sink)) return nullptr;
    }
    throw stuck("the film cannot be read: no more pictures come");
}

std::chrono::nanoseconds DecodeChain::duration() const {
    gint64 nanoseconds = 0;
    if (!gst_element_query_duration(pipeline_.get(), GST_FORMAT_TIME, &nanoseconds)) return {};
    return std::chrono::nanoseconds(std::max<gint64>(nanoseconds, 0));
}

void DecodeChain::throw_pending_error() const {
    const GstPtr<GstMessage> message(gst_bus_pop_filtered(bus_.get(), GST_MESSAGE_ERROR));
    if (message) throw media_error(message.get());
}

MediaError media_error(GstMessage* message) {
    GError* raw = nullptr;
    gchar* raw_debug = nullptr;
    gst_message_parse_error(message, &raw, &raw_debug);
    const GstPtr<GError> error(raw);
    const GstPtr<gchar> debug(raw_debug);
    if (raw->domain == GST_RESOURCE_ERROR && is_from_source(message))
        return {FaultOwner::transport, "the film's file cannot be read" + cause_in(debug ? debug.get() : "")};
    if (!is_marked(message, own_words)) {
        log::debug("film not read: {}", raw->message);
        return in_plain_words(raw);
    }
    const bool is_unsupported = g_error_matches(raw, GST_STREAM_ERROR, GST_STREAM_ERROR_CODEC_NOT_FOUND) ||
                                g_error_matches(raw, GST_STREAM_ERROR, GST_STREAM_ERROR_NOT_IMPLEMENTED);
    return {is_unsupported ? MediaState::unsupported : MediaState::failed, raw->message};
}

}  // namespace vitrine
