#include "base/settings/settings_file.hpp"

#include "base/settings/toml_table.hpp"
#include "base/system/atomic_file.hpp"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace vitrine {

namespace {

constexpr std::size_t max_file_bytes = 1U << 20;

std::optional<SettingValue> to_value(const toml::node& node) {
    if (const auto* text = node.as_string()) return SettingValue(text->get());
    if (const auto* whole_value = node.as_integer()) return SettingValue(whole_value->get());
    if (const auto* value = node.as_floating_point()) return SettingValue(value->get());
    if (const auto* flag = node.as_boolean()) return SettingValue(flag->get());
    return std::nullopt;
}

std::string list_of_keys(std::string_view section) {
    std::string list;
    for (const SettingKey& key : setting_keys())
        if (key.name.starts_with(section)) list += fmt::format("{}{}", list.empty() ? "" : ", ", key.name);
    return list;
}

std::string list_of_sections() {
    std::string list;
    for (const SettingKey& key : setting_keys()) {
        const std::string section = fmt::format("[{}]", key.name.substr(0, key.name.find('.')));
        if (list.find(section) == std::string::npos) list += (list.empty() ? "" : ", ") + section;
    }
    return list;
}

/// Why a value is not allowed. @param error  its text may say more than the key does
std::string reason(const SettingKey& key, const std::invalid_argument& error) {
    const std::string_view fault = error.what();
    return fault.empty() ? fmt::format("it must be {}", key.allowed())
                         : fmt::format("{}; it must be {}", fault, key.allowed());
}

void read_key(const std::string& name, const std::string& section, const toml::node& node,
              const std::string& source, Settings& settings) {
    const unsigned line = node.source().begin.line;
    const SettingKey* key = find_setting_key(name);
    if (key == nullptr)
        throw SettingsError(fmt::format("{}:{}: there is no key '{}'; this section has {}", source, line,
                                        name, list_of_keys(section + ".")));
    try {
        const std::optional<SettingValue> value = to_value(node);
        if (!value) throw std::invalid_argument("");  // a table or a list
        key->assign(settings, *value);
    } catch (const std::invalid_argument& error) {
        throw SettingsError(fmt::format("{}:{}: the value of '{}' is not allowed; {}", source, line, name,
                                        reason(*key, error)));
    }
}

}  // namespace

std::vector<std::string> read_settings(std::string_view toml, const std::string& source, Settings& settings) {
    toml::table root;
    try {
        root = toml_table(toml, source);
    } catch (const TomlError& error) {
        throw SettingsError(fmt::format("{}:{}: {}", source, error.line, error.what()));
    }
    std::vector<std::string> passed_over;
    for (const auto& [section, node] : root) {
        const std::string section_name(section.str());
        const toml::table* table = node.as_table();
        if (table == nullptr || list_of_keys(section_name + ".").empty())
            throw SettingsError(fmt::format("{}:{}: there is no section [{}]; there are {}", source,
                                            node.source().begin.line, section_name, list_of_sections()));
        for (const auto& [key, value] : *table) {
            const std::string name = section_name + "." + std::string(key.str());
            if (const RetiredKey* retired = find_retired_key(name))
                passed_over.push_back(fmt::format("{}:{}: '{}' is not a setting any more; remove it. {}",
                                                  source, value.source().begin.line, name, retired->advice));
            else
                read_key(name, section_name, value, source, settings);
        }
    }
    return passed_over;
}

std::vector<std::string> read_settings_file(const std::filesystem::path& file, Settings& settings) {
    std::string toml;
    try {
        toml = read_file(file, max_file_bytes);
    } catch (const std::system_error& error) {
        throw SettingsError(error.what());
    }
    return read_settings(toml, file.string(), settings);
}

void apply_setting(const std::string& name, const std::string& text, Settings& settings) {
    const SettingKey* key = find_setting_key(name);
    if (key == nullptr) throw SettingsError(fmt::format("there is no setting '{}'", name));
    try {
        try {
            key->assign(settings, setting_value(text));
        } catch (const std::invalid_argument&) {
            key->assign(settings, text);  // a text may look like a number: a folder may be called 2026
        }
    } catch (const std::invalid_argument& error) {
        throw SettingsError(fmt::format("--{} '{}' is not allowed; {}", name, text, reason(*key, error)));
    }
}

}  // namespace vitrine
