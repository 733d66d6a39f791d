#pragma once

#include "analyzer/store/store_place.hpp"
#include "analyzer/video/frame_source.hpp"
#include "base/state/stored_shot.hpp"

#include <optional>
#include <string>

namespace vitrine::analyzer {

/// Puts a photo into the store: as it is where it is small, else made smaller, with its transparency.
///
/// @param size  of the upright photo
/// @return  its place, which is given away where it is too large, and empty where the disk had no room;
/// nothing where it cannot be read
std::optional<StoredShot> store_photo(const std::string& file, const MediaInfo& size,
                                      const StorePlace& place);

/// Puts a copy of a film into the store, of which no clips can be made. The times in it are the film's.
std::optional<StoredShot> store_film(const std::string& file, const MediaInfo& size, const StorePlace& place);

}  // namespace vitrine::analyzer
