#pragma once

#include "analyzer/tapestry/weave/candidates.hpp"
#include "base/state/tapestry.hpp"

#include <filesystem>

namespace vitrine::analyzer {

/// Writes the frames that were kept of a film as sheets of JPEG, small, so that a player can show about any
/// moment at once while a finger goes over the strip. Sheets that are there already stay.
/// @param directory  the tapestry's
/// @param tapestry   its folder is used
/// @return           what the index says of them
/// @throws std::system_error, std::runtime_error; they name the file
KeptSheets write_frame_sheets(const std::filesystem::path& directory, const Tapestry& tapestry,
                              const Candidates& candidates);

/// Draws the digits and writes them, so that a player can tell times without reading fonts.
/// @return  their size; 0 where they cannot be drawn, which is logged
DigitCells write_digits(const std::filesystem::path& directory, const Tapestry& tapestry);

}  // namespace vitrine::analyzer
