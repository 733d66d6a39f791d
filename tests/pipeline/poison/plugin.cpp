// A decoder that misbehaves, for tests alone: it stands in for that of AV1 films where GStreamer is led
// to it, and does by the width of the picture what broken decoders do.

#include <gst/gst.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <vector>

namespace {

constexpr int width_abort = 100;
constexpr int width_sleep = 104;
constexpr int width_allocate = 108;
constexpr int width_spin = 112;

struct PoisonDecoder {
    GstElement parent;
    GstPad* sink;
    GstPad* source;
};

struct PoisonDecoderClass {
    GstElementClass parent;
};

GType poison_decoder_get_type();
G_DEFINE_TYPE(PoisonDecoder, poison_decoder, GST_TYPE_ELEMENT)

GstStaticPadTemplate sink_template =
    GST_STATIC_PAD_TEMPLATE("sink", GST_PAD_SINK, GST_PAD_ALWAYS, GST_STATIC_CAPS("video/x-av1"));
GstStaticPadTemplate source_template =
    GST_STATIC_PAD_TEMPLATE("src", GST_PAD_SRC, GST_PAD_ALWAYS, GST_STATIC_CAPS("video/x-raw"));

[[noreturn]] void allocate_for_ever() {
    constexpr std::size_t piece = 64U << 20;
    std::vector<char*> pieces;
    while (true) {
        char* memory = static_cast<char*>(std::malloc(piece));
        if (memory == nullptr) std::abort();
        std::memset(memory, 1, piece);
        pieces.push_back(memory);
    }
}

void misbehave(int width) {
    volatile bool goes_on = true;
    switch (width) {
    case width_abort:
        std::abort();
    case width_sleep:
        std::this_thread::sleep_for(std::chrono::hours(1));
        break;
    case width_allocate:
        allocate_for_ever();
    case width_spin:
        while (goes_on) {
        }
        break;
    default:
        break;
    }
}

gboolean take_event(GstPad* pad, GstObject* parent, GstEvent* event) {
    if (GST_EVENT_TYPE(event) == GST_EVENT_CAPS) {
        GstCaps* caps = nullptr;
        int width = 0;
        gst_event_parse_caps(event, &caps);
        gst_structure_get_int(gst_caps_get_structure(caps, 0), "width", &width);
        misbehave(width);
    }
    return gst_pad_event_default(pad, parent, event);
}

GstFlowReturn take_frame(GstPad*, GstObject*, GstBuffer* frame) {
    gst_buffer_unref(frame);
    return GST_FLOW_ERROR;
}

void poison_decoder_class_init(PoisonDecoderClass* type) {
    GstElementClass* element = GST_ELEMENT_CLASS(type);
    gst_element_class_add_static_pad_template(element, &sink_template);
    gst_element_class_add_static_pad_template(element, &source_template);
    gst_element_class_set_static_metadata(element, "Poison", "Codec/Decoder/Video", "Misbehaves", "Vitrine");
}

void poison_decoder_init(PoisonDecoder* self) {
    self->sink = gst_pad_new_from_static_template(&sink_template, "sink");
    gst_pad_set_event_function(self->sink, take_event);
    gst_pad_set_chain_function(self->sink, take_frame);
    gst_element_add_pad(&self->parent, self->sink);
    self->source = gst_pad_new_from_static_template(&source_template, "src");
    gst_element_add_pad(&self->parent, self->source);
}

gboolean start(GstPlugin* plugin) {
    return gst_element_register(plugin, "av1dec", GST_RANK_NONE, poison_decoder_get_type());
}

}  // namespace

#define PACKAGE "vitrine-poison"
GST_PLUGIN_DEFINE(GST_VERSION_MAJOR, GST_VERSION_MINOR, vitrinepoison, "Misbehaves", start, "1", "LGPL",
                  "vitrine", "vitrine")
