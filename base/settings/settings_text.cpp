#include "base/settings/settings_text.hpp"

#include "base/settings/setting_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace vitrine {

namespace {

constexpr std::string_view head =
    "Settings of Vitrine. This file lists every key with its default, commented "
    "out; remove the '#' to change it.\n"
    "An unknown key or a wrong value stops the program. The error names this "
    "file, the line and the allowed values.\n"
    "Every key is also an option of both programs: --section.key VALUE.";

/// A text in quotes with the escapes of TOML.
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

/// One line of text as lines of comment.
std::string comment(std::string_view text) {
    constexpr std::size_t max_length = 120;
    std::string lines;
    std::string line = "#";
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string_view word = text.substr(begin, end - begin);
        if (line.size() + 1 + word.size() > max_length) lines += std::exchange(line, "#") + "\n";
        line += ' ';
        line += word;
        begin = end + 1;
    }
    return lines + line + "\n";
}

std::string comments(std::string_view text) {
    std::string made;
    while (true) {
        const std::size_t end = text.find('\n');
        made += comment(text.substr(0, end));
        if (end == std::string_view::npos) return made;
        text.remove_prefix(end + 1);
    }
}

std::string_view section_of(const SettingKey& key) {
    return key.name.substr(0, key.name.find('.'));
}

std::string assignment(const SettingKey& key, const Settings& settings) {
    return fmt::format("{} = {}\n", key.name.substr(key.name.find('.') + 1), escaped(key.text(settings)));
}

}  // namespace

std::string to_toml(const Settings& settings) {
    std::string toml;
    std::string_view section;
    for (const SettingKey& key : setting_keys()) {
        if (section_of(key) != section) toml += fmt::format("[{}]\n", section_of(key));
        section = section_of(key);
        toml += assignment(key, settings);
    }
    return toml;
}

std::string documented_toml() {
    std::string toml = comments(head);
    std::string_view section;
    for (const SettingKey& key : setting_keys()) {
        const bool is_first = section_of(key) != section;
        section = section_of(key);
        if (is_first) toml += fmt::format("\n[{}]\n", section);
        if (!is_first && !key.help.empty()) toml += '\n';
        if (!key.help.empty()) toml += comments(key.help);
        toml += "#" + assignment(key, {});
    }
    return toml;
}

}  // namespace vitrine
