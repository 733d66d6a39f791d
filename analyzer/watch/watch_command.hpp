#pragma once

#include "base/settings/settings.hpp"

#include <functional>

namespace vitrine::analyzer {

/// Reads the settings. @throws SettingsError
using ReadSettings = std::function<Settings()>;

/// The moment at which watching ends by itself.
enum class WatchEnd {
    never,
    analysed,  // the catalogue is up to date; no tapestry is woven
    woven,     // the catalogue is up to date, and the films have their tapestries
};

/// Runs `vitrine-analyzer watch`: keeps the catalogue equal to the media folder until SIGTERM or SIGINT, or
/// until `end`. On SIGHUP the settings are read again, for the children that are started from then on.
///
/// @param settings  settings of the start
/// @return the exit status; a failure where an end was given and the catalogue is not up to date
int watch_media(const Settings& settings, const ReadSettings& read_settings, WatchEnd end);

}  // namespace vitrine::analyzer
