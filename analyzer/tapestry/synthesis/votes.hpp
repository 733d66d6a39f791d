#pragma once

#include "analyzer/tapestry/synthesis/patch_match.hpp"

namespace vitrine::analyzer {

/// Makes the target that costs least for the matches as they are: each pixel is the mean of what its matched
/// patches propose, weighted as in the energy.
/// Source: Simakov et al. 2008, the update step for eq. 1. Rounded to whole grey levels it still costs least.
///
/// @param target  changed in place
void take_votes(const PatchMatch& matches, const PatchImage& source, const PatchRules& rules,
                PatchImage& target, const RunTasks& run);

}  // namespace vitrine::analyzer
