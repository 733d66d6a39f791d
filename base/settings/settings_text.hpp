#pragma once

#include "base/settings/settings.hpp"

#include <string>

namespace vitrine {

/// A settings file that says the same as these settings.
std::string to_toml(const Settings& settings);

/// The content of config/vitrine.toml: every key with its comment, commented out at its default. Lines have
/// at most 120 characters.
std::string documented_toml();

}  // namespace vitrine
