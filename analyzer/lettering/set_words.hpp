#pragma once

#include "base/settings/settings.hpp"

#include <span>
#include <string>

namespace vitrine::analyzer {

/// Sets each text as a picture of the state directory. This process enters a sandbox for good: it reads fonts
/// and writes these pictures, and nothing else, as texts come from strangers.
/// @throws std::system_error, std::runtime_error naming what cannot be written
void set_words(std::span<const std::string> texts, const Settings& settings);

}  // namespace vitrine::analyzer
