#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace vitrine {

/// Where a file of that name is written before it is complete: what is found there after a crash is worth
/// nothing.
inline std::filesystem::path unfinished(const std::filesystem::path& path) {
    return path.string() + ".new";
}

/// Replaces a file as a whole: a sibling is written and fsynced, renamed over it, the directory
/// fsynced. Readers see the old content or the new, also after a power cut.
/// @throws std::system_error; the old content then stands
void replace_file(const std::filesystem::path& path, std::string_view content);

/// Makes a file that was written under another name, in the same directory, the one of that name: it is
/// fsynced and renamed, the directory fsynced. @throws std::system_error; the written file is then removed
void publish_file(const std::filesystem::path& written, const std::filesystem::path& path);

/// The whole content. @throws std::system_error where it cannot be read or exceeds max_bytes (EFBIG)
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes = 64U << 20);

}  // namespace vitrine
