#pragma once

#include <string>

namespace vitrine::analyzer {

/// Finds the file of a model that comes with the programs, or the operator's in its place.
///
/// @param wanted  the path in the settings; "" asks for none
/// @param usual   that setting's default
/// @return        `wanted`. Where it is the default: the file of that name in ../share/vitrine beside the
///                folder of this program, as it stands in a build and where it is installed; "" if it is not
///                there.
std::string find_model(const std::string& wanted, const std::string& usual);

}  // namespace vitrine::analyzer
