#pragma once

#include "base/media/gst_ptr.hpp"
#include "base/media/media_type.hpp"

#include <gst/gst.h>

#include <string>

namespace vitrine {

// The common parts of DecodeChain, for a film's pictures, and SoundChain, for its sound.

/// A new pipeline with the film's file and its demuxer. A chain adds the elements after the demuxer. For an
/// animation the pipeline is empty.
struct FilmBegin {
    GstPtr<GstElement> pipeline;
    GstElement* demuxer = nullptr;  // held by the pipeline; none: an animation
    MediaFormat format{};
};

/// Starts GStreamer and makes the pipeline.
/// @throws MediaError like media_format(), and if the file is not a film
FilmBegin begin_film(const std::string& path);

/// Makes an element in a bin, which owns it. @throws std::runtime_error if the plugin is not installed
GstElement* add_element(GstBin* bin, const char* factory);

/// The caps of a stream that a demuxer has just found. None: the demuxer does not tell.
GstPtr<GstCaps> stream_caps(GstPad* pad);

/// Posts an error message of ours as an element would do it, because exceptions must not cross GStreamer's
/// threads.
///
/// @param mark  name for is_marked() to recognise the message
void post_error(GstElement* element, GstStreamError code, const std::string& text, const char* mark);
bool is_marked(GstMessage* error, const char* mark);

}  // namespace vitrine
