#pragma once

#include <filesystem>
#include <string>

namespace vitrine::link {

/// Reads the key of a wall: one line of 64 hexadecimal digits.
/// @throws std::runtime_error with a sentence that names the file
std::string read_wall_key(const std::filesystem::path& file);

}  // namespace vitrine::link
