#pragma once

#include "base/settings/setting_keys.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// A wrong setting. The text names file and line (or the option), the value and the allowed values.
class SettingsError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Reads TOML over the given settings. Keys that an earlier version had are passed over.
/// @param source  name of the text in errors
/// @return  a line for each key that is passed over: place, name and advice
/// @throws SettingsError if the text is no TOML, or has an unknown section or key, or a value that is not
/// allowed
std::vector<std::string> read_settings(std::string_view toml, const std::string& source, Settings& settings);

/// Reads a file over the given settings, as read_settings does. @throws SettingsError also if the file cannot
/// be read
std::vector<std::string> read_settings_file(const std::filesystem::path& file, Settings& settings);

/// Sets one `--section.key value` of a command line. @throws SettingsError
void apply_setting(const std::string& name, const std::string& text, Settings& settings);

}  // namespace vitrine
