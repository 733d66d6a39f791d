#pragma once

#include <string>
#include <vector>

namespace vitrine::player {

/// The names that a file may have in the media folder, most likely first, from a name as somebody typed it: a
/// path on this machine, absolute or relative to a folder; a path relative to the media folder; or the
/// share's name on another machine ("\\box\media\a.jpg", "smb://box/media/a.jpg", "Z:\a.jpg",
/// "/Volumes/media/a.jpg"). Accepts any bytes; does not look at the disk.
/// @param given   the name as it was typed
/// @param folder  absolute; the folder in which it was typed
/// @param root    absolute; the media folder
/// @return        paths relative to the media folder; none leads out of it
std::vector<std::string> media_names(const std::string& given, const std::string& folder,
                                     const std::string& root);

}  // namespace vitrine::player
