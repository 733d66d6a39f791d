#pragma once

#include <filesystem>

namespace vitrine {

// The player notes the size of its screens for the analyzer, which makes clips no larger than they will be
// shown: docs/catalogue.md.

/// The longest side, px, of the largest canvas so far; 0: not known yet.
/// @param state  the state directory
int noted_screen_side(const std::filesystem::path& state);

/// Writes the longest side, px. @throws std::system_error
void note_screen_side(const std::filesystem::path& state, int side);

}  // namespace vitrine
