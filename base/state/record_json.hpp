#pragma once

#include "base/state/record.hpp"

#include <string>
#include <string_view>

namespace vitrine {

/// The record as one JSON object, format version 3 (docs/catalogue.md), without a newline.
/// A path that is not UTF-8 is written with replacement characters, and exactly in "path_hex".
std::string to_json(const MediaRecord& record);

/// @throws std::runtime_error naming the key at fault if the text is no record of a known version
MediaRecord record_from_json(std::string_view text);

std::string_view name_of(MediaState state);
std::string_view name_of(ShotEnd end);
std::string_view name_of(MediaKind kind);

}  // namespace vitrine
