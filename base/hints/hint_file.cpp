#include "base/hints/hint_file.hpp"

#include "base/hints/hint_words.hpp"
#include "base/settings/toml_table.hpp"

#include <fmt/format.h>

#include <functional>
#include <initializer_list>

namespace vitrine {

namespace {

struct Key {
    std::string_view name;
    std::string allowed;
    bool (*assign)(Hints&, const toml::node&);  // false: not allowed
};

std::optional<int> whole_number(const toml::node& node, int most) {
    const auto* value = node.as_integer();
    if (value == nullptr || value->get() < 1 || value->get() > most) return std::nullopt;
    return static_cast<int>(value->get());
}

bool assign_period(Hints& hints, const toml::node& node) {
    const auto* text = node.as_string();
    if (text != nullptr) hints.period = period_named(text->get());
    return hints.period.has_value();
}

bool assign_hours(Hints& hints, const toml::node& node) {
    const auto* text = node.as_string();
    if (text != nullptr) hints.hours = hours_named(text->get());
    return hints.hours.has_value();
}

bool assign_seconds(Hints& hints, const toml::node& node) {
    const auto seconds = whole_number(node, most_dwell_seconds);
    if (seconds) hints.dwell = std::chrono::seconds(*seconds);
    return seconds.has_value();
}

bool assign_repeat(Hints& hints, const toml::node& node) {
    hints.repeat = whole_number(node, most_repeats);
    return hints.repeat.has_value();
}

bool assign_sound(Hints& hints, const toml::node& node) {
    const auto* value = node.as_boolean();
    if (value != nullptr) hints.sound = value->get();
    return value != nullptr;
}

const std::vector<Key>& keys() {
    static const std::vector<Key> keys{
        {"period", R"(days like "2026-12-01..2026-12-24", "2026-12-01.." or "..2026-12-24")", &assign_period},
        {"hours", R"(times like "08-18", "22-06" or "08:30-18:00")", &assign_hours},
        {"seconds", fmt::format("a whole number from 1 to {}", most_dwell_seconds), &assign_seconds},
        {"repeat", fmt::format("a whole number from 1 to {}", most_repeats), &assign_repeat},
        {"sound", "true or false", &assign_sound}};
    return keys;
}

std::string names_of_keys() {
    std::string names;
    for (const Key& key : keys())
        names += (names.empty() ? "" : ", ") + std::string(key.name);
    return names;
}

}  // namespace

HintFile read_hints(std::string_view toml, const std::string& source) {
    HintFile file;
    const auto fault = [&](unsigned line, const std::string& what) {
        file.faults.push_back(fmt::format("{}:{}: {}", source, line, what));
    };
    toml::table root;
    try {
        root = toml_table(toml, source);
    } catch (const TomlError& error) {
        fault(error.line, error.what());
        return file;
    }
    for (const auto& [key_name, node] : root) {
        const std::string_view name = key_name;
        const auto key =
            std::find_if(keys().begin(), keys().end(), [&](const Key& known) { return known.name == name; });
        if (key == keys().end())
            fault(node.source().begin.line,
                  fmt::format("there is no key '{}'; there are {}", name, names_of_keys()));
        else if (!key->assign(file.hints, node))
            fault(node.source().begin.line,
                  fmt::format("the value of '{}' is not allowed; it must be {}", name, key->allowed));
    }
    return file;
}

}  // namespace vitrine
