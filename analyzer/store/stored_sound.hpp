#pragma once

#include "analyzer/store/store_place.hpp"
#include "base/state/stored_shot.hpp"

#include <string>

namespace vitrine::analyzer {

/// Writes the sound of a film into the store, coded as it is in the film, in a Matroska file whose times are
/// the film's.
///
/// @return  its place: `is_dropped` where it is too large; without a file there where the disk had no room;
///          no file name where the film has no sound that can be played
StoredSound store_sound(const std::string& file, const StorePlace& place);

}  // namespace vitrine::analyzer
