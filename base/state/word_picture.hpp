#pragma once

#include <filesystem>
#include <string_view>

namespace vitrine {

// Words on the wall come as pictures, which the analyzer sets and the player shows: docs/catalogue.md,
// "Words".

/// The folder of these pictures. @param state  the state directory
std::filesystem::path word_folder(const std::filesystem::path& state);

/// The picture of a line of text: a PNG (RGBA).
/// @param state  the state directory
/// @param text   any bytes
std::filesystem::path word_picture(const std::filesystem::path& state, std::string_view text);

}  // namespace vitrine
