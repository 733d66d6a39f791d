#include "player/settings_change.hpp"

#include "base/settings/setting_keys.hpp"

namespace vitrine::player {

SettingsChange settings_change(const Settings& before, const Settings& after) {
    SettingsChange change{.settings = before};
    for (const SettingKey& key : setting_keys()) {
        if (key.effect == SettingEffect::analyzer || key.text(before) == key.text(after)) continue;
        if (key.effect == SettingEffect::restart) {
            change.later.emplace_back(key.name);
            continue;
        }
        change.now.emplace_back(key.name);
        key.copy(after, change.settings);
        if (key.effect == SettingEffect::new_walls) change.are_walls_new = true;
    }
    return change;
}

}  // namespace vitrine::player
