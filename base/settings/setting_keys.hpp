#pragma once

#include "base/settings/settings.hpp"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace vitrine {

/// What a file or a command line can hold.
using SettingValue = std::variant<bool, std::int64_t, double, std::string>;

/// One key of the settings.
struct SettingKey {
    std::string name;     // section.key, as in the file
    std::string allowed;  // what may stand there, in words: "a whole number from 1 to 64"

    /// @throws std::invalid_argument where the value is not allowed; the settings then stay as they were
    std::function<void(Settings&, const SettingValue&)> assign;

    /// The key's value as it would stand in the file.
    std::function<std::string(const Settings&)> text;
};

/// All keys in the order of config/vitrine.toml.
std::span<const SettingKey> setting_keys();

/// Nothing where there is no such key.
const SettingKey* find_setting_key(std::string_view name);

/// A value from a command line: a whole number, a number, true/false or the text itself.
SettingValue setting_value(const std::string& text);

}  // namespace vitrine
