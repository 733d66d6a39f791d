#pragma once

#include "base/settings/setting_kind.hpp"
#include "base/settings/settings.hpp"

#include <span>
#include <string>
#include <string_view>

namespace vitrine {

/// The time at which a running program follows a changed value.
enum class SettingEffect {
    analyzer,   // the player does not read it
    restart,    // when the program starts again
    now,        // at once
    new_walls,  // at once: the player makes its walls anew
};

/// One key of the settings.
struct SettingKey {
    std::string_view name;  // section.key, as in the file
    SettingKind kind;
    SettingEffect effect;
    std::string_view
        help;  // the comment in config/vitrine.toml; empty: the comment above the key before counts

    /// The allowed values in words: "a whole number from 1 to 64".
    std::string allowed() const;

    /// @throws std::invalid_argument if the value is not allowed; the settings then stay unchanged
    void assign(Settings& settings, const SettingValue& value) const;

    /// The key's value as it would stand in the file.
    std::string text(const Settings& settings) const;

    /// Gives `to` the value of this key in `from`.
    void copy(const Settings& from, Settings& to) const;
};

/// All keys in the order of config/vitrine.toml. The file, the options of both programs, the manual page and
/// the player's reload come from this table. A new setting needs its field in settings.hpp, its line in
/// setting_keys.cpp, and the target `settings_file`, which writes config/vitrine.toml.
std::span<const SettingKey> setting_keys();

/// Null if there is no such key.
const SettingKey* find_setting_key(std::string_view name);

}  // namespace vitrine
