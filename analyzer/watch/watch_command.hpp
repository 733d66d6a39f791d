#pragma once

#include "base/settings/settings.hpp"

#include <functional>

namespace vitrine::analyzer {

/// Reads the settings. @throws SettingsError
using ReadSettings = std::function<Settings()>;

/// Runs `vitrine-analyzer watch`: keeps the catalogue equal to the media folder until SIGTERM or SIGINT, or
/// with `is_once` until it is up to date. On SIGHUP the settings are read again, for the children that are
/// started from then on.
///
/// @param settings  settings of the start
/// @return the exit status; with `is_once` a failure where the catalogue is not up to date
int watch_media(const Settings& settings, const ReadSettings& read_settings, bool is_once);

}  // namespace vitrine::analyzer
