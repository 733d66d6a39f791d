#pragma once

#include "base/settings/settings.hpp"

#include <map>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace vitrine {

/// The settings as command-line options: --config FILE, and --SECTION.KEY VALUE for every key.
class SettingOptions {
  public:
    /// Adds the options; `this` must outlive the parse.
    void add_to(CLI::App& app);

    /// Adds a shorter name for an option: --slots for --layout.slots.
    void add_alias(CLI::App& app, const std::string& alias, const std::string& key);

    /// Reads the defaults, then the file (--config, else the installed one if it exists), then the options.
    /// @throws SettingsError
    Settings settings() const;

  private:
    struct Given {
        const CLI::Option* option = nullptr;
        std::string text;
    };

    std::string config_;
    std::map<std::string, Given> given_;  // key: name of the setting
    std::map<std::string, Given> aliased_;
};

}  // namespace vitrine
