#pragma once

#include "base/system/unique_fd.hpp"

#include <filesystem>

namespace vitrine {

/// Finds a file below a folder and holds it (O_PATH), without opening it for reading. No link is followed
/// below the folder, whoever puts it there in the meantime; the folder itself may be reached through links.
///
/// @param root  the folder
/// @param path  relative to it, without ".."
/// @throws std::system_error; ELOOP where a part of the path is a link
UniqueFd hold_below(const std::filesystem::path& root, const std::filesystem::path& path);

}  // namespace vitrine
