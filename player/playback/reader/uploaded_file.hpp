#pragma once

#include "base/system/unique_fd.hpp"

#include <string>

namespace vitrine::player {

/// Opens a file of the media folder to read it. Follows no link below the folder. May take long on a share.
/// @param path  below the folder
/// @throws MediaError if it cannot be opened, or is not a regular file
UniqueFd open_upload(const std::string& root, const std::string& path);

}  // namespace vitrine::player
