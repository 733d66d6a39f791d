#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace vitrine::player {

/// Puts a text in the place of a file, so that a reader sees the old one or the new. Not fsynced: after a
/// power cut it is written anew anyway.
/// @throws std::system_error
void write_metrics(const std::filesystem::path& file, const std::string& text);

/// Of the hottest thermal zone, degrees Celsius; nothing where there is none.
/// @param zones  /sys/class/thermal
std::optional<double> hottest(const std::filesystem::path& zones);

}  // namespace vitrine::player
