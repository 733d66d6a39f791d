#pragma once

#include "base/settings/setting_keys.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace vitrine {

/// A setting that is wrong: says file and line (or the option), the value and what is allowed.
class SettingsError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Reads TOML over the settings given. @param source  what the errors call the text
/// @throws SettingsError on text that is no TOML, an unknown section or key, a value that is not allowed
void read_settings(std::string_view toml, const std::string& source, Settings& settings);

/// @throws SettingsError also where the file cannot be read
void read_settings_file(const std::filesystem::path& file, Settings& settings);

/// One `--section.key value` of a command line. @throws SettingsError
void apply_setting(const std::string& name, const std::string& text, Settings& settings);

}  // namespace vitrine
