#include "base/settings/setting_options.hpp"

#include "base/settings/settings_file.hpp"
#include "base/system/log.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine {

namespace {

constexpr const char* installed_file = VITRINE_SETTINGS_FILE;  // set by the build

}  // namespace

void SettingOptions::add_to(CLI::App& app) {
    app.add_option("--config", config_,
                   fmt::format("Settings file (default: {}, if it exists)", installed_file));
    for (const SettingKey& key : setting_keys()) {
        const std::string name(key.name);
        Given& given = given_[name];
        given.option = app.add_option("--" + name, given.text,
                                      fmt::format("{} (default: {})", key.allowed(), key.text(Settings{})))
                           ->group("Settings, as in the settings file")
                           ->type_name("");
    }
}

void SettingOptions::add_alias(CLI::App& app, const std::string& alias, const std::string& key) {
    Given& given = aliased_[key];
    given.option =
        app.add_option("--" + alias, given.text, fmt::format("Short for --{}", key))->type_name("");
}

Settings SettingOptions::settings() const {
    Settings settings;
    std::vector<std::string> passed_over;
    if (!config_.empty())
        passed_over = read_settings_file(config_, settings);
    else if (std::filesystem::exists(installed_file))
        passed_over = read_settings_file(installed_file, settings);
    for (const std::string& line : passed_over)
        log::warning("{}", line);
    for (const auto* options : {&given_, &aliased_})
        for (const auto& [name, given] : *options)
            if (given.option->count() > 0) apply_setting(name, given.text, settings);
    return settings;
}

}  // namespace vitrine
