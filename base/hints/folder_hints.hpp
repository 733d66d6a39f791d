#pragma once

#include "base/hints/hints.hpp"

#include <map>
#include <string>
#include <string_view>

namespace vitrine {

/// The hints of the files `.vitrine.toml` by the path of the folder below the media folder; "" is the media
/// folder. And those of the files beside media, by the path of the medium.
using FolderHints = std::map<std::string, Hints>;

/// The hints of one file. They come from its folders, the outermost first, each from its name and then from
/// its `.vitrine.toml`, then from the file's own name, and last from the file beside it. A later hint
/// replaces an earlier one.
/// @param path  below the media folder, '/' between folders, any bytes
Hints hints_of(std::string_view path, const FolderHints& folders);

/// The content of STATE/hints.json, which the analyzer writes for the player (docs/catalogue.md).
std::string to_json(const FolderHints& folders);

/// @throws std::runtime_error if the text has another form
FolderHints folder_hints_from_json(std::string_view text);

}  // namespace vitrine
