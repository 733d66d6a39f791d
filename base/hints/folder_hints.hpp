#pragma once

#include "base/hints/hints.hpp"

#include <map>
#include <string>
#include <string_view>

namespace vitrine {

/// What the files `.vitrine.toml` say, by the folder's path below the media folder, "" being that itself.
using FolderHints = std::map<std::string, Hints>;

/// All that is said of one file: by the folders from the outermost on, each by its name and then by its
/// `.vitrine.toml`, and at last by the file's own name. What is said later counts.
/// @param path  below the media folder, '/' between folders, any bytes
Hints hints_of(std::string_view path, const FolderHints& folders);

/// STATE/hints.json, by which the analyzer tells the player (docs/catalogue.md).
std::string to_json(const FolderHints& folders);

/// @throws std::runtime_error where the text is not of that form
FolderHints folder_hints_from_json(std::string_view text);

}  // namespace vitrine
