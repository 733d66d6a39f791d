#pragma once

#include "player/playback/film_feed.hpp"

#include <functional>
#include <string>

namespace vitrine::player {

/// For each decoder of the table (decoder_table.hpp) the best in hardware that can be used, where there is
/// one: stateless V4L2 first, whose state is ours and not a firmware's, then VA, then stateful V4L2.
///
/// @param is_usable  whether a GStreamer element is installed and its device opens
DecoderMap hardware_decoders(const std::function<bool(const std::string& element)>& is_usable);

/// True if this machine has the element and its device opens.
bool is_usable_here(const std::string& element);

/// For the log: which codecs are decoded by what.
std::string in_words(const DecoderMap& decoders);

}  // namespace vitrine::player
