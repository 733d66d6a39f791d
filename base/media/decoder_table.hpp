#pragma once

#include "base/media/gst_ptr.hpp"
#include "base/media/media_type.hpp"

#include <optional>

namespace vitrine {

/// The elements that turn one kind of coded stream into raw pictures or raw sound.
struct DecoderRow {
    const char* caps;     // what the demuxer's pad says
    const char* parser;   // nullptr: none needed
    const char* decoder;  // nullptr: the stream is raw already
};

/// How a coded stream is decoded here, nothing where it is not.
std::optional<DecoderRow> decoder_for(const GstCaps* stream);

/// The same of a coded stream of sound.
std::optional<DecoderRow> sound_decoder_for(const GstCaps* stream);

/// The demuxer element of a film's container.
const char* demuxer_for(MediaFormat container);

}  // namespace vitrine
