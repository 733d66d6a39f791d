#include "base/settings/settings_snapshot.hpp"

#include "base/settings/setting_keys.hpp"
#include "base/system/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <string_view>

namespace vitrine {

namespace {

/// "..." with anything in between, as TOML has it.
std::string escaped(const std::string& text) {
    if (!text.starts_with('"')) return text;
    std::string made = "\"";
    for (const char c : std::string_view(text).substr(1, text.size() - 2)) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            made += {'\\', c};
        else if (byte < 0x20 || byte == 0x7f)
            made += fmt::format("\\u{:04x}", byte);
        else
            made += c;
    }
    return made + '"';
}

}  // namespace

std::string to_toml(const Settings& settings) {
    std::string toml;
    std::string section;
    for (const SettingKey& key : setting_keys()) {
        const std::size_t dot = key.name.find('.');
        if (key.name.substr(0, dot) != section) {
            section = key.name.substr(0, dot);
            toml += fmt::format("[{}]\n", section);
        }
        toml += fmt::format("{} = {}\n", key.name.substr(dot + 1), escaped(key.text(settings)));
    }
    return toml;
}

SettingsSnapshot::SettingsSnapshot(const Settings& settings)
    : file_(::memfd_create("settings", MFD_CLOEXEC)) {
    if (!file_.is_open()) throw_errno("make a file of settings in memory");
    replace(settings);
}

void SettingsSnapshot::replace(const Settings& settings) {
    const std::string toml = to_toml(settings);
    UniqueFd next(::memfd_create("settings", MFD_CLOEXEC));
    if (!next.is_open()) throw_errno("make a file of settings in memory");
    if (::write(next.get(), toml.data(), toml.size()) != static_cast<ssize_t>(toml.size()))
        throw_errno("write settings to memory");
    if (::dup3(next.get(), file_.get(), O_CLOEXEC) < 0) throw_errno("replace settings in memory");
}

std::string SettingsSnapshot::path() const {
    return fmt::format("/proc/{}/fd/{}", ::getpid(), file_.get());
}

}  // namespace vitrine
