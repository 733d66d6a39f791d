#pragma once

#include "base/media/gst_ptr.hpp"
#include "base/media/media_type.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// The elements that decode one kind of stream into raw pictures or raw sound.
struct DecoderRow {
    const char* caps;     // caps of the demuxer's pad
    const char* parser;   // nullptr: none needed
    const char* decoder;  // nullptr: the stream is raw already
};

/// The decoder of a coded video stream. None: it is not decoded here.
std::optional<DecoderRow> decoder_for(const GstCaps* stream);

/// The decoder of a coded sound stream. None: it is not decoded here.
std::optional<DecoderRow> sound_decoder_for(const GstCaps* stream);

/// Loads the plugins that decode the pictures of a film, or read its sound without decoding it, so that it
/// can be read in a sandbox. GStreamer must have been started.
void load_decoders(MediaFormat container);

/// The name of the demuxer element for a film's container. An animation has none: libvips reads it.
const char* demuxer_for(MediaFormat container);

/// The names of all elements that films of any kind need, to load them ahead. Some may not be installed.
std::vector<std::string> decoding_elements();

}  // namespace vitrine
