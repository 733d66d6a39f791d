#pragma once

#include "base/catalogue/record.hpp"
#include "base/settings/settings.hpp"

#include <filesystem>
#include <string>

namespace vitrine {

/// The record of one file as it is now: with its shots, or with the reason why there are none.
///
/// @param file  anywhere; its path in the record is relative to settings.media.root where it lies in there
/// @throws std::system_error where there is no such file
MediaRecord record_of_file(const std::filesystem::path& file, const Settings& settings);

/// Writes the sheet that shows how the file's regions came about, as PNG.
/// @return the record
/// @throws MediaError where there is nothing to show
MediaRecord explain_file(const std::filesystem::path& file, const std::string& sheet,
                         const Settings& settings);

}  // namespace vitrine
