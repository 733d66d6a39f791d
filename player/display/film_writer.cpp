#include "player/display/film_writer.hpp"

#include "base/system/handle.hpp"

#include <fmt/format.h>
#include <gst/app/gstappsrc.h>
#include <gst/gst.h>

#include <array>
#include <cassert>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

namespace vitrine::player {

namespace {

constexpr guint64 pictures_waiting = 4;  // limit of the encoder's queue; each has width * height * 4 bytes
constexpr GstClockTime room_patience = 2 * GST_MSECOND;    // between two looks for room
constexpr GstClockTime max_ending_time = 60 * GST_SECOND;  // to encode the queue and write the last fragment
constexpr guint fragment_milliseconds = 2000;

void unref_element(GstElement* element) {
    gst_object_unref(element);
}

void stop_pipeline(GstElement* pipeline) {
    gst_element_set_state(pipeline, GST_STATE_NULL);
    gst_object_unref(pipeline);
}

void unref_bus(GstBus* bus) {
    gst_object_unref(bus);
}

void unref_message(GstMessage* message) {
    gst_message_unref(message);
}

void unref_caps(GstCaps* caps) {
    gst_caps_unref(caps);
}

using GstBusHandle = Handle<GstBus, &unref_bus>;
using GstCapsHandle = Handle<GstCaps, &unref_caps>;
using GstElementHandle = Handle<GstElement, &unref_element>;
using GErrorHandle = Handle<GError, &g_error_free>;
using GstMessageHandle = Handle<GstMessage, &unref_message>;
using GstPipelineHandle = Handle<GstElement, &stop_pipeline>;

struct Part {
    const char* element;
    const char* package;
};

// The elements in the order of the chain.
constexpr std::array<Part, 7> parts{{{"appsrc", "gstreamer1.0-plugins-base"},
                                     {"videoconvert", "gstreamer1.0-plugins-base"},
                                     {"capsfilter", "libgstreamer1.0-0"},
                                     {"x264enc", "gstreamer1.0-plugins-ugly"},
                                     {"h264parse", "gstreamer1.0-plugins-bad"},
                                     {"mp4mux", "gstreamer1.0-plugins-good"},
                                     {"filesink", "libgstreamer1.0-0"}}};

std::string reason_of(GstMessage& message) {
    GError* error = nullptr;
    gst_message_parse_error(&message, &error, nullptr);
    const GErrorHandle owned(error);
    return error->message;
}

}  // namespace

struct FilmWriter::Chain {
    std::string path;
    GstPipelineHandle pipeline;
    std::array<GstElement*, parts.size()> elements{};  // owned by the pipeline
    GstClockTime frame_time = 0;
    std::optional<std::chrono::nanoseconds> first;
    std::optional<std::chrono::nanoseconds> last;

    GstAppSrc* source() const { return GST_APP_SRC(elements[0]); }

    [[noreturn]] void fail(const std::string& reason) const {
        throw std::runtime_error(fmt::format("write film '{}': {}", path, reason));
    }

    void build() {
        pipeline.reset(gst_pipeline_new("film"));
        for (std::size_t i = 0; i < parts.size(); ++i) {
            elements[i] = gst_element_factory_make(parts[i].element, nullptr);
            if (!elements[i])
                fail(fmt::format("GStreamer has no {}: install {}", parts[i].element, parts[i].package));
            gst_bin_add(GST_BIN(pipeline.get()), elements[i]);
            if (i > 0 && !gst_element_link(elements[i - 1], elements[i]))
                fail(fmt::format("{} does not accept the output of {}", parts[i].element,
                                 parts[i - 1].element));
        }
    }

    void configure(int width, int height, double rate) {
        int numerator = 0;
        int denominator = 1;
        gst_util_double_to_fraction(rate, &numerator, &denominator);
        frame_time = gst_util_uint64_scale_int(GST_SECOND, denominator, numerator);
        const GstCapsHandle caps(gst_caps_new_simple(
            "video/x-raw", "format", G_TYPE_STRING, "RGBA", "width", G_TYPE_INT, width, "height", G_TYPE_INT,
            height, "framerate", GST_TYPE_FRACTION, numerator, denominator, nullptr));
        g_object_set(elements[0], "caps", caps.get(), "format", GST_FORMAT_TIME, "max-bytes", guint64{0},
                     nullptr);
        // Without this format the encoder keeps RGB's full colour, which browsers and television sets do not
        // play.
        gst_util_set_object_arg(G_OBJECT(elements[2]), "caps", "video/x-raw, format=I420");
        gst_util_set_object_arg(G_OBJECT(elements[3]), "speed-preset", "superfast");
        gst_util_set_object_arg(G_OBJECT(elements[3]), "pass", "quant");
        // A fragmented film has no list of edits: with reordered pictures, players lose the last ones.
        g_object_set(elements[3], "quantizer", 20, "key-int-max", 60, "bframes", 0, nullptr);
        // In fragments, so that an index does not grow in memory and a film that is cut off can be opened.
        g_object_set(elements[5], "fragment-duration", fragment_milliseconds, nullptr);
        gst_util_set_object_arg(G_OBJECT(elements[6]), "buffer-mode", "unbuffered");
        g_object_set(elements[6], "location", path.c_str(), nullptr);
    }

    /// Waits for a message of `type` or an error; nullptr if none comes in time.
    GstMessageHandle next(GstMessageType type, GstClockTime patience) const {
        const GstBusHandle bus(gst_element_get_bus(pipeline.get()));
        const auto wanted = static_cast<GstMessageType>(type | GST_MESSAGE_ERROR);
        return GstMessageHandle(gst_bus_timed_pop_filtered(bus.get(), patience, wanted));
    }

    // A blocking appsrc would wait for ever for room in a chain that has failed. Here the bus is asked, too.
    void wait_for_room() const {
        while (gst_app_src_get_current_level_buffers(source()) >= pictures_waiting)
            if (const GstMessageHandle error = next(GST_MESSAGE_ERROR, room_patience))
                fail(reason_of(*error));
    }

    void expect(GstFlowReturn result) const {
        if (result == GST_FLOW_OK) return;
        const GstMessageHandle error = next(GST_MESSAGE_ERROR, GST_SECOND);
        fail(error ? reason_of(*error) : gst_flow_get_name(result));
    }

    /// Ends the film. Returns the reason if it is not complete.
    std::optional<std::string> end() const {
        if (!last) return "no picture came";
        gst_app_src_end_of_stream(source());  // a failure comes on the bus as well
        const GstMessageHandle message = next(GST_MESSAGE_EOS, max_ending_time);
        if (!message) return "the encoder does not finish";
        if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_ERROR) return reason_of(*message);
        return std::nullopt;
    }
};

FilmWriter::FilmWriter(const std::filesystem::path& path, int width, int height, double rate)
    : chain_(std::make_unique<Chain>()) {
    gst_init(nullptr, nullptr);
    chain_->path = path.string();
    chain_->build();
    chain_->configure(width, height, rate);
    if (gst_element_set_state(chain_->pipeline.get(), GST_STATE_PLAYING) == GST_STATE_CHANGE_FAILURE)
        chain_->expect(GST_FLOW_ERROR);
}

FilmWriter::~FilmWriter() {
    if (chain_ && chain_->last) chain_->end();  // a destructor cannot report an error; finish() does
}

void FilmWriter::add(const Picture& picture, std::chrono::nanoseconds time) {
    assert(chain_ && !picture.pixels.empty());
    if (chain_->last && time <= *chain_->last) return;
    if (!chain_->first) chain_->first = time;
    chain_->last = time;

    chain_->wait_for_room();
    GstBuffer* buffer = gst_buffer_new_allocate(nullptr, picture.pixels.size(), nullptr);
    if (!buffer) chain_->fail("no memory for a picture");
    gst_buffer_fill(buffer, 0, picture.pixels.data(), picture.pixels.size());
    GST_BUFFER_PTS(buffer) = static_cast<GstClockTime>((time - *chain_->first).count());
    GST_BUFFER_DURATION(buffer) = chain_->frame_time;
    chain_->expect(gst_app_src_push_buffer(chain_->source(), buffer));  // takes the buffer
}

void FilmWriter::finish() {
    if (!chain_) return;
    const std::unique_ptr<Chain> ending = std::move(chain_);
    if (const std::optional<std::string> reason = ending->end()) ending->fail(*reason);
}

}  // namespace vitrine::player
