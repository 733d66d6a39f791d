#pragma once

#include "analyzer/store/store_place.hpp"
#include "base/state/stored_shot.hpp"

#include <string>

namespace vitrine::analyzer {

/// Puts the sound of a film into the store, coded as it is in the film, in a Matroska file whose times are
/// the film's.
///
/// @return  its place, which is given away where it is too large, and empty where the disk had no room; no
/// file where the film has no sound that could be heard
StoredSound store_sound(const std::string& file, const StorePlace& place);

}  // namespace vitrine::analyzer
