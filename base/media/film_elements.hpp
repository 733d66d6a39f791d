#pragma once

#include "base/media/gst_ptr.hpp"
#include "base/media/media_type.hpp"

#include <gst/gst.h>

#include <string>

namespace vitrine {

// What a chain for a film's pictures and one for its sound have in common.

/// A new pipeline with the film's file and its demuxer in it, for a chain behind that.
struct FilmBegin {
    GstPtr<GstElement> pipeline;
    GstElement* demuxer = nullptr;  // held by the pipeline
    MediaFormat format{};
};

/// Starts GStreamer.
/// @throws MediaError what media_type() throws, or: it is not a film
FilmBegin begin_film(const std::string& path);

/// A new element in a bin, which holds it. @throws std::runtime_error where the plugin is not there
GstElement* add_element(GstBin* bin, const char* factory);

/// Of a stream that a demuxer has just found; none where it does not say.
GstPtr<GstCaps> stream_caps(GstPad* pad);

/// An error message of ours, as an element would post it: exceptions must not cross GStreamer's threads.
///
/// @param mark  tells it from others: is_marked()
void post_error(GstElement* element, GstStreamError code, const std::string& text, const char* mark);
bool is_marked(GstMessage* error, const char* mark);

}  // namespace vitrine
