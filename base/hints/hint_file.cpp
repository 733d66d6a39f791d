#include "base/hints/hint_file.hpp"

#include "base/hints/hint_words.hpp"
#include "base/settings/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine {

namespace {

std::optional<HintValue> value_of(const toml::node& node) {
    if (const auto* text = node.as_string()) return HintValue(text->get());
    if (const auto* number = node.as_integer()) return HintValue(number->get());
    if (const auto* flag = node.as_boolean()) return HintValue(flag->get());
    return std::nullopt;
}

std::string list_of_keys() {
    std::string list;
    for (const HintWord& word : hint_words())
        list += fmt::format("{}{}", list.empty() ? "" : ", ", word.key);
    return list;
}

/// Reads one key into the hints. @return  the fault; empty: none
std::string fault_in(std::string_view key, const toml::node& node, Hints& hints) {
    const auto words = hint_words();
    const auto word = std::ranges::find(words, key, &HintWord::key);
    if (word == words.end()) return fmt::format("there is no key '{}'; there are {}", key, list_of_keys());
    const std::optional<HintValue> value = value_of(node);
    if (value && word->assign(hints, *value)) return {};
    return fmt::format("the value of '{}' is not allowed; it must be {}", key, word->allowed);
}

}  // namespace

HintFile read_hints(std::string_view toml, const std::string& source) {
    HintFile file;
    file.faults = faults_in_keys(toml, source, [&](std::string_view key, const toml::node& node) {
        return fault_in(key, node, file.hints);
    });
    return file;
}

}  // namespace vitrine
