#pragma once

#include <string>

namespace vitrine::analyzer {

/// Finds the file of the face model.
///
/// @param wanted  the setting `analyzer.face_model`
/// @return        `wanted`. Where that is the default path: the file of that name in ../share/vitrine beside
/// the
///                folder of this program, as it stands in a build and where it is installed; "" where it is
///                not there, so that the cascade finds faces.
std::string find_face_model(const std::string& wanted);

}  // namespace vitrine::analyzer
