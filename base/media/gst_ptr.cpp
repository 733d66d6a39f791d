#include "base/media/gst_ptr.hpp"

#include "base/system/log.hpp"

#include <fmt/format.h>

#include <mutex>
#include <stdexcept>

namespace vitrine {

namespace {

/// A library that has run out of descriptors says so thousands of times, in words that no operator
/// understands.
void log_for_library(const gchar* domain, GLogLevelFlags, const gchar* text, gpointer) {
    log::debug("{}: {}", domain ? domain : "a library", text ? text : "");
}

}  // namespace

void start_gstreamer() {
    static std::once_flag once;
    std::call_once(once, [] {
        g_log_set_default_handler(&log_for_library, nullptr);
        GError* error = nullptr;
        const bool started = gst_init_check(nullptr, nullptr, &error) != FALSE;
        const GstPtr<GError> owned(error);
        if (!started)
            throw std::runtime_error(
                fmt::format("start GStreamer: {}", error ? error->message : "no reason given"));
    });
}

GstPtr<GstElement> make_element(const char* factory) {
    GstElement* element = gst_element_factory_make(factory, nullptr);
    if (!element)
        throw std::runtime_error(fmt::format("the GStreamer element '{}' is not installed", factory));
    gst_object_ref_sink(element);
    return GstPtr<GstElement>(element);
}

void load_element(const char* factory) {
    GstElementFactory* found = gst_element_factory_find(factory);
    if (!found) return;
    GstPluginFeature* loaded = gst_plugin_feature_load(GST_PLUGIN_FEATURE(found));
    if (loaded) gst_object_unref(loaded);
    gst_object_unref(found);
}

GstPtr<GstElement> make_bin(const char* description) {
    GError* error = nullptr;
    GstElement* bin = gst_parse_bin_from_description(description, TRUE, &error);
    if (bin) gst_object_ref_sink(bin);
    GstPtr<GstElement> owned(bin);
    const GstPtr<GError> why(
        error);  // GStreamer may warn and still return a bin; our bins must not have warnings
    if (why || !owned)
        throw std::runtime_error(
            fmt::format("build '{}': {}", description, why ? why->message : "no reason given"));
    return owned;
}

}  // namespace vitrine
