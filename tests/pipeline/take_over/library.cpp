// Takes a reader over, for tests alone, and has it try everything that a hostile file would. GStreamer takes
// it for its decoder of AV1 where it is led to it; loaded before the program, it stands before libjpeg. What
// it reaches it says on the standard error and in the file "reached" of the folder for temporary files.

#include "tests/taken_over.hpp"

#include <dlfcn.h>
#include <gst/gst.h>

#include <cstdlib>
#include <mutex>

namespace {

using vitrine::taken_over::Prey;
using vitrine::taken_over::Try;

std::string of_environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

/// The descriptor by which the process holds a file. -1: none.
int descriptor_of(const std::string& file) {
    constexpr int most = 64;
    for (int fd = 0; fd < most; ++fd) {
        std::array<char, 4096> name{};
        const std::string link = "/proc/self/fd/" + std::to_string(fd);
        const ssize_t n = ::readlink(link.c_str(), name.data(), name.size());
        if (n > 0 && std::string(name.data(), static_cast<std::size_t>(n)) == file) return fd;
    }
    return -1;
}

void write_line(int fd, const std::string& line) {
    if (::write(fd, line.data(), line.size()) < 0) std::abort();
}

/// Tries all. Each line is written at once: the process may end at the next try.
void take_over() {
    const Prey prey{.media = of_environment("PREY_MEDIA"),
                    .record = of_environment("PREY_RECORD"),
                    .folder = of_environment("TMPDIR"),
                    .socket = of_environment("PREY_SOCKET"),
                    .descriptor = descriptor_of(of_environment("PREY_MEDIA"))};
    const std::string left = (prey.folder / "reached").string();
    const int file = prey.folder.empty() ? -1 : ::open(left.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, S_IRWXU);
    const auto say = [&](const std::string& words) {
        write_line(STDERR_FILENO, words + "\n");
        if (file >= 0) write_line(file, words + "\n");
    };
    say("taken over");
    for (const Try& one : vitrine::taken_over::file_tries(prey))
        if (one.reaches()) say("reached file: " + one.name);
    for (const Try& one : vitrine::taken_over::call_tries(prey))
        if (one.reaches()) say("reached call: " + one.name);
    say("the end");
}

void take_over_once() {
    static std::once_flag once;
    std::call_once(once, take_over);
}

struct HostileDecoder {
    GstElement parent;
};

struct HostileDecoderClass {
    GstElementClass parent;
};

GType hostile_decoder_get_type();
G_DEFINE_TYPE(HostileDecoder, hostile_decoder, GST_TYPE_ELEMENT)

GstStaticPadTemplate sink_template =
    GST_STATIC_PAD_TEMPLATE("sink", GST_PAD_SINK, GST_PAD_ALWAYS, GST_STATIC_CAPS("video/x-av1"));
GstStaticPadTemplate source_template =
    GST_STATIC_PAD_TEMPLATE("src", GST_PAD_SRC, GST_PAD_ALWAYS, GST_STATIC_CAPS("video/x-raw"));

GstFlowReturn take_frame(GstPad*, GstObject*, GstBuffer* frame) {
    gst_buffer_unref(frame);
    take_over_once();
    return GST_FLOW_ERROR;
}

void hostile_decoder_class_init(HostileDecoderClass* type) {
    GstElementClass* element = GST_ELEMENT_CLASS(type);
    gst_element_class_add_static_pad_template(element, &sink_template);
    gst_element_class_add_static_pad_template(element, &source_template);
    gst_element_class_set_static_metadata(element, "Hostile", "Codec/Decoder/Video", "Takes over", "Vitrine");
}

void hostile_decoder_init(HostileDecoder* self) {
    GstPad* sink = gst_pad_new_from_static_template(&sink_template, "sink");
    gst_pad_set_chain_function(sink, take_frame);
    gst_element_add_pad(&self->parent, sink);
    gst_element_add_pad(&self->parent, gst_pad_new_from_static_template(&source_template, "src"));
}

gboolean start(GstPlugin* plugin) {
    return gst_element_register(plugin, "av1dec", GST_RANK_NONE, hostile_decoder_get_type());
}

}  // namespace

#define PACKAGE "vitrine-take-over"
GST_PLUGIN_DEFINE(GST_VERSION_MAJOR, GST_VERSION_MINOR, vitrinetakeover, "Takes over", start, "1", "LGPL",
                  "vitrine", "vitrine")

/// Stands before libjpeg's.
extern "C" __attribute__((visibility("default"))) int jpeg_read_header(void* picture, int is_required) {
    using Header = int (*)(void*, int);
    static const auto next = reinterpret_cast<Header>(::dlsym(RTLD_NEXT, "jpeg_read_header"));  // NOLINT
    take_over_once();
    return next(picture, is_required);
}
