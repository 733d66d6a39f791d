#pragma once

#include "player/playback/film_feed.hpp"

#include <functional>
#include <string>

namespace vitrine::player {

/// The best usable hardware decoder for each decoder of the table (decoder_table.hpp) that has one: first
/// stateless V4L2, whose state is kept by us and not by firmware, then VA, then stateful V4L2.
///
/// @param is_usable  true if the GStreamer element is installed and its device opens
DecoderMap hardware_decoders(const std::function<bool(const std::string& element)>& is_usable);

/// True if this machine has the element and its device opens.
bool is_usable_here(const std::string& element);

/// The codecs and their decoders, for the log.
std::string in_words(const DecoderMap& decoders);

}  // namespace vitrine::player
