#pragma once

#include "player/scene/files/show_files.hpp"

#include <string>
#include <vector>

namespace vitrine::player {

/// One entry of a level of the folder tree: a file, or a folder with several files.
struct FolderEntry {
    std::string path;        // relative to the media folder
    bool is_folder = false;  // false: a file
    bool operator==(const FolderEntry&) const = default;
};

/// The deepest folder that holds all these files; empty: the media folder.
std::string common_folder(const RecordList& files);

/// The entries of the level on which files part: their deepest common folder's files and sub-folders, side by
/// side, in the order of their paths. A folder of one file is that file. A folder whose files all lie in one
/// of its sub-folders is that sub-folder.
std::vector<FolderEntry> level_entries(const RecordList& files);

}  // namespace vitrine::player
