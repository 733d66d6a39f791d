#pragma once

#include "base/system/message_socket.hpp"
#include "player/playback/reader/reader_messages.hpp"

#include <sys/types.h>

namespace vitrine::player {

/// The descriptors of a new reader, and the process that it must not outlive.
struct ReaderHandles {
    const MessageSocket& player;
    const UniqueFd& memory;  // for the order's slots
    pid_t host = -1;
};

/// Makes this process, just forked, a reader, and ends it when all is done: opens the file, gives up all
/// rights, decodes the file, and hands its pictures to the player. If it fails, it says why.
[[noreturn]] void become_reader(const ReaderOrder& order, const ReaderHandles& handles);

}  // namespace vitrine::player
