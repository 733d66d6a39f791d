#pragma once

#include <gst/app/gstappsink.h>
#include <gst/gst.h>

#include <memory>

namespace vitrine {

/// Releases one reference. Each type has its own overload; a type without one does not compile.
struct GstUnref {
    void operator()(GstElement* element) const { gst_object_unref(element); }

    void operator()(GstBus* bus) const { gst_object_unref(bus); }

    void operator()(GstPad* pad) const { gst_object_unref(pad); }

    void operator()(GstCaps* caps) const { gst_caps_unref(caps); }

    void operator()(GstSample* sample) const { gst_sample_unref(sample); }

    void operator()(GstMessage* message) const { gst_message_unref(message); }

    void operator()(GstTagList* tags) const { gst_tag_list_unref(tags); }

    void operator()(GstEvent* event) const { gst_event_unref(event); }

    void operator()(GError* error) const { g_error_free(error); }

    void operator()(gchar* text) const { g_free(text); }
};

/// The only owner of one reference.
template <typename T> using GstPtr = std::unique_ptr<T, GstUnref>;

/// Loads GStreamer once in a process. Call it before any other function of GStreamer. Thread-safe. From then
/// on the complaints of all libraries of GLib are debug lines of the log.
/// @throws std::runtime_error if GStreamer cannot start
void start_gstreamer();

/// Makes an element, no longer floating. @throws std::runtime_error if the plugin is not installed
GstPtr<GstElement> make_element(const char* factory);

/// Loads the plugin of an element, so that the element can be made later in a sandbox. A plugin that is not
/// installed is passed over: the element cannot be made then.
void load_element(const char* factory);

/// Makes a bin from a pipeline description in the syntax of gst-launch. Its open ends are the pads "sink" and
/// "src".
/// @throws std::runtime_error if the description is wrong or a plugin is missing
GstPtr<GstElement> make_bin(const char* description);

}  // namespace vitrine
