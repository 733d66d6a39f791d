#pragma once

#include "base/hints/hints.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// The name of a folder's file of hints.
constexpr std::string_view hint_file_name = ".vitrine.toml";

/// The content of a folder's file of hints. A fault in one line does not affect the hints of the others.
struct HintFile {
    Hints hints;
    std::vector<std::string> faults;  // each with file, line and allowed values
};

/// Reads a key for each hint of hint_words().
/// @param source  name of the text in the faults
HintFile read_hints(std::string_view toml, const std::string& source);

}  // namespace vitrine
