#pragma once

#include "analyzer/tapestry/synthesis/patch_match.hpp"

namespace vitrine::analyzer {

/// The target that costs least for the matches as they are: each pixel the mean of what its matched patches
/// say, weighted as the energy weighs them.
/// Source: Simakov et al. 2008, the update step for eq. 1. Rounding to whole grey levels keeps it the least.
///
/// @param target  changed in place
void take_votes(const PatchMatch& matches, const PatchImage& source, const PatchRules& rules,
                PatchImage& target, const RunTasks& run);

}  // namespace vitrine::analyzer
