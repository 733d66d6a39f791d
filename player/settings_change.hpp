#pragma once

#include "base/settings/settings.hpp"

#include <string>
#include <vector>

namespace vitrine::player {

/// What a running player makes of other settings than it began with.
struct SettingsChange {
    Settings settings;               // to go on with
    std::vector<std::string> now;    // keys that hold from now on
    std::vector<std::string> later;  // keys that hold once the player starts anew
    bool are_walls_new = false;      // the walls are to be made anew
};

/// Keys that are only the analyzer's are passed over.
SettingsChange settings_change(const Settings& before, const Settings& after);

}  // namespace vitrine::player
