#pragma once

#include <filesystem>

namespace vitrine {

/// Gives the records, tapestries and thumbnails of version 0.1 their names of today. That version named them
/// by a hash of 64 bits, for which a file's name could be made up that collides with another. Call it while
/// the catalogue is locked, before it is loaded. A file that cannot be renamed keeps its name.
/// @param state  has the folders `catalogue`, `tapestry` and `thumbnails`
void rename_former(const std::filesystem::path& state);

}  // namespace vitrine
