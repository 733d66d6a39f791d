#pragma once

#include "base/settings/settings.hpp"

#include <string>
#include <vector>

namespace vitrine::player {

/// The changes of settings that a running player can follow, and those that it cannot.
struct SettingsChange {
    Settings settings;               // from now on
    std::vector<std::string> now;    // keys whose new values hold from now on
    std::vector<std::string> later;  // keys whose new values hold after a restart
    bool are_walls_new = false;      // the walls must be made anew
};

/// Passes over the keys of the analyzer.
SettingsChange settings_change(const Settings& before, const Settings& after);

}  // namespace vitrine::player
