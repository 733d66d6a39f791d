#pragma once

#include <string>
#include <string_view>

namespace vitrine {

/// True for the name of a wall or of a box: 1 to 63 letters, digits, '-', '_' and '.', a letter or digit
/// first. So it is a level of a topic, a word of output.canvas and a part of a file's name.
bool is_wall_name(std::string_view name);

/// A sentence that says why a text is no such name; empty: it is one.
std::string wall_name_fault(std::string_view name);

}  // namespace vitrine
