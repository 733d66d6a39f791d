#pragma once

#include "analyzer/film/frame_source.hpp"
#include "analyzer/store/store_place.hpp"
#include "base/state/stored_shot.hpp"

#include <optional>
#include <string>

namespace vitrine::analyzer {

/// Writes a photo into the store: as it is where it is small, else made smaller, with its transparency.
///
/// @param size  size of the upright photo
/// @return  its place: `is_dropped` where it is too large; without a file there where the disk had no room.
///          None: the photo cannot be read
std::optional<StoredShot> store_photo(const std::string& file, const MediaInfo& size,
                                      const StorePlace& place);

/// Copies a film into the store that no clips can be made of. The times in the copy are the film's.
std::optional<StoredShot> store_film(const std::string& file, const MediaInfo& size, const StorePlace& place);

}  // namespace vitrine::analyzer
