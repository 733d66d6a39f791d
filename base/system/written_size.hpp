#pragma once

#include <cstdint>

namespace vitrine {

/// Where the last written byte of an open file ends: its size, less a hole that reaches to the end, which is
/// what a copy into a preallocated file leaves while it is under way. A hole with data behind it is part of
/// the content: file systems store long runs of zeros so.
/// @param fd  of a regular file; its offset is moved
/// @return    the size also where the file system cannot tell
std::uint64_t written_size(int fd);

}  // namespace vitrine
