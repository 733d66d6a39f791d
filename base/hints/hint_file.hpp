#pragma once

#include "base/hints/hints.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// The name of a folder's own file of hints.
constexpr std::string_view hint_file_name = ".vitrine.toml";

/// What it says, and what is wrong with it. What is right counts all the same.
struct HintFile {
    Hints hints;
    std::vector<std::string> faults;  // file, line, what is allowed
};

/// Reads the keys period, hours, seconds, repeat and sound.
/// @param source  what the faults call the text
HintFile read_hints(std::string_view toml, const std::string& source);

}  // namespace vitrine
