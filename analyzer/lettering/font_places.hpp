#pragma once

#include <filesystem>
#include <vector>

namespace vitrine::analyzer {

/// The fonts of text, and what tells where they are: folders to be read below.
std::vector<std::filesystem::path> font_places();

}  // namespace vitrine::analyzer
