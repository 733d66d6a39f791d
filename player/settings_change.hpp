#pragma once

#include "base/settings/settings.hpp"

#include <string>
#include <vector>

namespace vitrine::player {

/// The changed settings, sorted by those that a running player can follow and those that it cannot.
struct SettingsChange {
    Settings settings;               // valid from now on
    std::vector<std::string> now;    // changed keys that are valid from now on
    std::vector<std::string> later;  // changed keys that are valid after a restart
    bool are_walls_new = false;      // the walls must be rebuilt
};

/// Compares settings. Skips the keys of the analyzer.
SettingsChange settings_change(const Settings& before, const Settings& after);

}  // namespace vitrine::player
