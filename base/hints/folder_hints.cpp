#include "base/hints/folder_hints.hpp"

#include "base/hints/hint_words.hpp"
#include "base/state/path_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <stdexcept>

namespace vitrine {

using Json = nlohmann::ordered_json;

namespace {

constexpr int current_version = 1;

Json to_json(const HintValue& value) {
    return std::visit([](const auto& one) { return Json(one); }, value);
}

std::optional<HintValue> value_of(const Json& json) {
    if (json.is_boolean()) return HintValue(json.get<bool>());
    if (json.is_number_integer()) return HintValue(json.get<std::int64_t>());
    if (json.is_string()) return HintValue(json.get<std::string>());
    return std::nullopt;
}

Json to_object(const std::string& folder, const Hints& hints) {
    Json object{{"folder", folder}};
    if (!is_utf8(folder)) object["folder_hex"] = to_hex(folder);
    for (const HintWord& word : hint_words())
        if (const auto value = word.value(hints)) object[std::string(word.key)] = to_json(*value);
    return object;
}

/// @throws std::runtime_error naming the key at fault
Hints hints_in(const Json& object) {
    Hints hints;
    for (const HintWord& word : hint_words()) {
        const auto found = object.find(std::string(word.key));
        if (found == object.end()) continue;
        const auto value = value_of(*found);
        if (!value || !word.assign(hints, *value))
            throw std::runtime_error(fmt::format("hints: '{}' has a wrong value", word.key));
    }
    return hints;
}

}  // namespace

Hints hints_of(std::string_view path, const FolderHints& folders) {
    const auto said_by = [&](std::string_view folder) {
        const auto found = folders.find(std::string(folder));
        return found == folders.end() ? Hints{} : found->second;
    };
    Hints hints = said_by("");
    std::size_t begin = 0;
    for (std::size_t end; (end = path.find('/', begin)) != std::string_view::npos; begin = end + 1) {
        hints = merged(hints, hints_in_name(path.substr(begin, end - begin), NamePart::folder));
        hints = merged(hints, said_by(path.substr(0, end)));
    }
    hints = merged(hints, hints_in_name(path.substr(begin), NamePart::file));
    return merged(hints, said_by(path));
}

std::string to_json(const FolderHints& folders) {
    Json list = Json::array();
    for (const auto& [folder, hints] : folders)
        list.push_back(to_object(folder, hints));
    return Json{{"version", current_version}, {"folders", list}}.dump(-1, ' ', false,
                                                                      Json::error_handler_t::replace);
}

FolderHints folder_hints_from_json(std::string_view text) {
    try {
        const Json json = Json::parse(text);
        if (json.at("version").get<int>() != current_version)
            throw std::runtime_error("hints: unknown version");
        FolderHints folders;
        for (const Json& object : json.at("folders")) {
            std::string folder = object.at("folder").get<std::string>();
            if (object.contains("folder_hex")) folder = from_hex(object.at("folder_hex").get<std::string>());
            folders[folder] = hints_in(object);
        }
        return folders;
    } catch (const Json::exception& error) {
        throw std::runtime_error(fmt::format("hints: {}", error.what()));
    }
}

}  // namespace vitrine
