#pragma once

#include <string>
#include <vector>

namespace vitrine::player {

/// What a file of the media folder may be called there, likeliest first, by how somebody called it: by its
/// path on this machine or from a folder of it, from the media folder on, or as the share shows it elsewhere
/// ("\\box\media\a.jpg", "smb://box/media/a.jpg", "Z:\a.jpg", "/Volumes/media/a.jpg"). Any bytes; nothing is
/// asked of the file system.
/// @param given   as it was typed
/// @param folder  absolute, where it was typed
/// @param root    absolute, the media folder
/// @return        paths from the media folder on, none of which leads out of it
std::vector<std::string> media_names(const std::string& given, const std::string& folder,
                                     const std::string& root);

}  // namespace vitrine::player
