#include "player/settings_change.hpp"

#include "base/settings/setting_keys.hpp"

#include <algorithm>
#include <array>

namespace vitrine::player {

namespace {

bool is_analyzers(const std::string& key) {
    return key.starts_with("analyzer.") || key.starts_with("store.");
}

/// What is read again for each picture, line or wall.
bool holds_at_once(const std::string& key) {
    constexpr std::array<const char*, 4> keys{"log.level", "metrics.file", "output.rotation",
                                              "output.margins"};
    if (key == "show.background") return false;  // photos are read with it
    return key.starts_with("layout.") || key.starts_with("show.") ||
           std::ranges::find(keys, key) != keys.end();
}

}  // namespace

SettingsChange settings_change(const Settings& before, const Settings& after) {
    SettingsChange change{.settings = before};
    for (const SettingKey& key : setting_keys()) {
        if (key.text(before) == key.text(after) || is_analyzers(key.name)) continue;
        (holds_at_once(key.name) ? change.now : change.later).push_back(key.name);
        change.are_walls_new =
            change.are_walls_new ||
            (holds_at_once(key.name) && (key.name.starts_with("layout.") || key.name.starts_with("show.")));
    }
    change.settings.log = after.log;
    change.settings.metrics = after.metrics;
    change.settings.layout = after.layout;
    change.settings.show = after.show;
    change.settings.show.background = before.show.background;
    change.settings.output.rotation = after.output.rotation;
    change.settings.output.margins = after.output.margins;
    return change;
}

}  // namespace vitrine::player
