#pragma once

#include <cstdint>

namespace vitrine {

/// The size of an open file without a hole at its end. A copy into a preallocated file has such a hole while
/// it is under way. A hole with data after it is part of the content: file systems store long runs of zeros
/// so.
/// @param fd  descriptor of a regular file; its offset is moved
/// @return    the full size if the file system cannot tell
std::uint64_t written_size(int fd);

}  // namespace vitrine
