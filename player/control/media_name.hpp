#pragma once

#include <string>
#include <vector>

namespace vitrine::player {

/// The names that a file may have in the media folder, likeliest first, from the name that somebody typed: a
/// path on this machine, absolute or from a folder, a path from the media folder on, or the name that the
/// share has elsewhere ("\\box\media\a.jpg", "smb://box/media/a.jpg", "Z:\a.jpg", "/Volumes/media/a.jpg").
/// Any bytes; the file system is not asked.
/// @param given   as it was typed
/// @param folder  absolute, where it was typed
/// @param root    absolute, the media folder
/// @return        paths from the media folder on, none of which leads out of it
std::vector<std::string> media_names(const std::string& given, const std::string& folder,
                                     const std::string& root);

}  // namespace vitrine::player
