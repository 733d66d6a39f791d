#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace vitrine {

/// Replaces a file as a whole: a sibling is written and fsynced, renamed over it, the directory
/// fsynced. Readers see the old content or the new, also after a power cut.
/// @throws std::system_error; the old content then stands
void replace_file(const std::filesystem::path& path, std::string_view content);

/// The whole content. @throws std::system_error where it cannot be read or exceeds max_bytes (EFBIG)
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes = 64U << 20);

}  // namespace vitrine
