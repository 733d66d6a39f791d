#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace vitrine {

/// The name of a file until it is complete. A file with this name that is found after a crash is worthless.
inline std::filesystem::path unfinished(const std::filesystem::path& path) {
    return path.string() + ".new";
}

/// Replaces a file as a whole: writes a new file beside it, fsyncs it, renames it over the old one, and
/// fsyncs the directory. Readers see the old content or the new, even after a power cut.
/// @throws std::system_error; the old content then stays
void replace_file(const std::filesystem::path& path, std::string_view content);

/// Replaces a file as a whole, but without fsync: readers see the old content or the new; after a power cut
/// the file may be empty. For files that are soon written again. @throws std::system_error
void replace_file_unsynced(const std::filesystem::path& path, std::string_view content);

/// Gives a file that was written under another name in the same directory its final name: fsyncs it, renames
/// it, and fsyncs the directory. @throws std::system_error; the written file is then removed
void publish_file(const std::filesystem::path& written, const std::filesystem::path& path);

/// Reads a whole file. @throws std::system_error if it cannot be read or exceeds max_bytes (EFBIG)
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes = 64U << 20);

}  // namespace vitrine
