#include "base/settings/settings_file.hpp"
#include "base/system/log.hpp"
#include "player/player.hpp"
#include "player/settings_change.hpp"

#include <fmt/format.h>

#include <utility>

// What a running player does with settings that have changed.

namespace vitrine::player {

/// @throws SettingsError; the old ones then stay
void Player::reload() {
    if (!options_.read_settings) return;
    SettingsChange change = settings_change(settings_, options_.read_settings());
    settings_ = std::move(change.settings);
    log::set_level(settings_.log.level);
    const auto list = [](const std::vector<std::string>& keys) {
        return keys.empty() ? "nothing" : fmt::format("{}", fmt::join(keys, ", "));
    };
    log::info("settings read again: {} changed; after a restart: {}", list(change.now), list(change.later));
    if (!change.are_walls_new) return;
    for (const SourceId source : sources_.retire_all())
        if (renderer_) renderer_->forget(source);
    make_stages();
    operation_->tell_wishes();
}

void Player::reload_or_tell() {
    try {
        reload();
    } catch (const SettingsError& error) {
        log::error("settings: {}; the old ones stay", error.what());
    }
}

}  // namespace vitrine::player
