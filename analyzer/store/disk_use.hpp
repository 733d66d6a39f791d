#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>

namespace vitrine::analyzer {

/// When a file was written or last read, whichever is later, ns since 1970.
std::int64_t used_ns(const struct stat& file);

/// How many of the bytes held below a directory are too many: beyond `most`, or where its disk has less than
/// `min_free_bytes` left.
std::uint64_t excess_bytes(std::uint64_t held, std::uint64_t most, const std::filesystem::path& directory,
                           std::uint64_t min_free_bytes);

}  // namespace vitrine::analyzer
