#pragma once

#include "base/system/message_socket.hpp"
#include "player/playback/reader/reader_messages.hpp"

#include <string>

namespace vitrine::player {

/// Reads the photo that the order names, and hands its picture to the player.
/// @param file    a name by which the open file can be read
/// @param memory  for the order's slots, of which the first is used
/// @throws MediaError as load_still() does
void read_photo(const ReaderOrder& order, const std::string& file, const MessageSocket& player,
                const UniqueFd& memory);

}  // namespace vitrine::player
