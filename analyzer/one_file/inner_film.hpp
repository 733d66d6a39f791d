#pragma once

#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/store/store_place.hpp"
#include "base/state/record.hpp"

#include <string>

namespace vitrine::analyzer {

/// Adds the film inside a motion photo to the photo's record: finds its region and puts a clip of it into the
/// store. The record tells why a film that the photo names is not played. A photo without one stays as it is.
/// @param photo  the file of a JPEG
/// @param place  its folder is there
void add_inner_film(MediaRecord& record, const std::string& photo, const StorePlace& place,
                    const AnalysisSettings& settings);

}  // namespace vitrine::analyzer
