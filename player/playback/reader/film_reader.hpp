#pragma once

#include "base/system/message_socket.hpp"
#include "player/playback/reader/reader_messages.hpp"

#include <string>

namespace vitrine::player {

/// Decodes the part of a film that the order names, and hands its pictures to the player. Follows the
/// player's messages meanwhile. Ends the process if the player closes its end.
/// @param file    a name by which the open file can be read
/// @param memory  for the order's slots
/// @throws MediaError why no more pictures come
void read_film(const ReaderOrder& order, const std::string& file, const MessageSocket& player,
               const UniqueFd& memory);

}  // namespace vitrine::player
