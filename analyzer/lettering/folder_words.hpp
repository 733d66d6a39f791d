#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vitrine::analyzer {

// The names of folders as pictures: docs/catalogue.md, "Words".

/// The names of these files' folders, as they are shown, whose pictures are not in the state directory yet.
/// Each comes once.
/// @param paths  of files below the media folder
/// @param state  directory
std::vector<std::string> lacking_folder_names(std::span<const std::string> paths,
                                              const std::filesystem::path& state);

/// Removes the pictures of all other words. A failure is left to the next time.
/// @param paths  all files
void remove_other_words(std::span<const std::string> paths, const std::filesystem::path& state);

}  // namespace vitrine::analyzer
