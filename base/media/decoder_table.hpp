#pragma once

#include "base/media/gst_ptr.hpp"
#include "base/media/media_type.hpp"

#include <optional>

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

/// The name of the demuxer element for a film's container.
const char* demuxer_for(MediaFormat container);

}  // namespace vitrine
