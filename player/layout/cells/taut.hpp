#pragma once

#include "player/layout/cells/seam_field.hpp"

#include <vector>

namespace vitrine::player {

/// Pulls the seams between two items taut, and those between two fillers: each becomes the shortest way
/// between its ends that does not cross a region or another seam. Junctions move to where the ways from them
/// are shortest, but not farther than half of the shortest seam there: so they do not jump while a short seam
/// becomes none in a motion. Other seams stay: they end what a shot has pixels for.
void pull_taut(std::vector<Seam>& seams, const SeamLimits& limits);

}  // namespace vitrine::player
