#pragma once

#include "base/settings/settings.hpp"

#include <string>

namespace vitrine {

/// Writes the settings as an equivalent TOML file.
std::string to_toml(const Settings& settings);

/// The content of config/vitrine.toml: every key with its comment, commented out at its default. Lines have
/// at most 120 characters.
std::string documented_toml();

}  // namespace vitrine
