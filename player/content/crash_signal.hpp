#pragma once

#include <filesystem>

namespace vitrine::player {

// A crash of this process by its own doing leaves the number of its signal in a file: a read or write where
// there is no memory, an abort. A kill from outside leaves nothing: by the kernel that is out of memory, by
// systemd's watchdog, by a person. Only the former says something about the files that were open.

constexpr const char* crashed_file = "crashed";  // below the state directory

/// Opens the file, empties it, and writes into it if this process crashes from now on. Where the file cannot
/// be opened nothing is noted. A stack that is used up is noted if it is that of the calling thread.
void note_own_crash(const std::filesystem::path& file);

/// @return true where the last process that noted into this file crashed by its own doing
bool has_own_crash(const std::filesystem::path& file);

}  // namespace vitrine::player
