#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::analyzer {

// The disk space of files that are made again when they are needed, and which of them go.

/// The time at which a file was written or last read, whichever is later, ns since 1970.
std::int64_t used_ns(const struct stat& file);

/// The bytes below a directory that are too many.
/// @param held            bytes below the directory
/// @param max_bytes       bytes allowed there
/// @param min_free_bytes  bytes that its disk must keep free
std::uint64_t excess_bytes(std::uint64_t held, std::uint64_t max_bytes,
                           const std::filesystem::path& directory, std::uint64_t min_free_bytes);

/// A file of the store that may go.
struct StoredFile {
    std::string name;
    std::uint64_t bytes = 0;
    std::int64_t used_ns = 0;  // when it was made or last read, since 1970
    bool is_named = false;     // by a record

    bool operator==(const StoredFile&) const = default;
};

/// The files to remove so that so many bytes become free: first those that no record names, then the others,
/// each time the one that was not used for longest first. All of them where that is not enough.
std::vector<StoredFile> files_to_remove(std::vector<StoredFile> files, std::uint64_t bytes);

}  // namespace vitrine::analyzer
