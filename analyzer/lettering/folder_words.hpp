#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace vitrine::analyzer {

// The names of folders as pictures: docs/catalogue.md, "Words".

/// The names of all folders on the way to these files, as they are shown.
/// @param paths  below the media folder
std::set<std::string> shown_folder_names(std::span<const std::string> paths);

/// The words whose pictures are not in the state directory yet.
std::vector<std::string> lacking_words(const std::set<std::string>& words,
                                       const std::filesystem::path& state);

/// Removes the pictures of all other words from the state directory. A failure is left to the next time.
void remove_other_words(const std::set<std::string>& words, const std::filesystem::path& state);

}  // namespace vitrine::analyzer
