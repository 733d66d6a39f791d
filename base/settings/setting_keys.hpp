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
    restart,    // at the next start of the program
    now,        // at once
    new_walls,  // at once, by building the walls again
};

/// One key of the settings.
struct SettingKey {
    std::string_view name;  // section.key, as in the file
    SettingKind kind;
    SettingEffect effect;
    std::string_view
        help;  // the comment in config/vitrine.toml; empty: the comment above the previous key applies

    /// The allowed values in words: "a whole number from 1 to 64".
    std::string allowed() const;

    /// @throws std::invalid_argument if the value is not allowed; the settings then stay unchanged
    void assign(Settings& settings, const SettingValue& value) const;

    /// The key's value in the form of the file.
    std::string text(const Settings& settings) const;

    /// Copies the value of this key.
    void copy(const Settings& from, Settings& to) const;
};

/// All keys in the order of config/vitrine.toml. The file, the options of both programs, the manual page and
/// the player's reload come from this table. A new setting needs its field in settings.hpp, its line in
/// setting_keys.cpp, and the target `settings_file`, which writes config/vitrine.toml.
std::span<const SettingKey> setting_keys();

/// The key of this name; null: there is none.
const SettingKey* find_setting_key(std::string_view name);

/// A key that an earlier version had. A settings file may still hold it.
struct RetiredKey {
    std::string_view name;    // section.key
    std::string_view advice;  // a sentence: the key that has its part today
};

/// The retired key of this name; null: there was none.
const RetiredKey* find_retired_key(std::string_view name);

}  // namespace vitrine
