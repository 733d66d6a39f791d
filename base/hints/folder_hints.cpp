#include "base/hints/folder_hints.hpp"

#include "base/hints/hint_words.hpp"
#include "base/state/path_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <stdexcept>

namespace vitrine {

using Json = nlohmann::ordered_json;

namespace {

constexpr int current_version = 1;

Json to_object(const std::string& folder, const Hints& hints) {
    Json object{{"folder", folder}};
    if (!is_utf8(folder)) object["folder_hex"] = to_hex(folder);
    if (hints.period) object["period"] = to_text(*hints.period);
    if (hints.hours) object["hours"] = to_text(*hints.hours);
    if (hints.dwell) object["seconds"] = hints.dwell->count();
    if (hints.repeat) object["repeat"] = *hints.repeat;
    if (hints.sound) object["sound"] = *hints.sound;
    return object;
}

template <typename T> std::optional<T> known(std::optional<T> value, const char* key) {
    if (!value) throw std::runtime_error(fmt::format("hints: '{}' is not understood", key));
    return value;
}

std::optional<int> number_in(const Json& object, const char* key, int most) {
    const int value = object.at(key).get<int>();
    return known(value >= 1 && value <= most ? std::optional(value) : std::nullopt, key);
}

Hints hints_in(const Json& object) {
    Hints hints;
    if (object.contains("period"))
        hints.period = known(period_named(object.at("period").get<std::string>()), "period");
    if (object.contains("hours"))
        hints.hours = known(hours_named(object.at("hours").get<std::string>()), "hours");
    if (object.contains("seconds"))
        hints.dwell = std::chrono::seconds(*number_in(object, "seconds", most_dwell_seconds));
    if (object.contains("repeat")) hints.repeat = number_in(object, "repeat", most_repeats);
    if (object.contains("sound")) hints.sound = object.at("sound").get<bool>();
    return hints;
}

}  // namespace

Hints hints_of(std::string_view path, const FolderHints& folders) {
    const auto folder_says = [&](std::string_view folder) {
        const auto found = folders.find(std::string(folder));
        return found == folders.end() ? Hints{} : found->second;
    };
    Hints hints = folder_says("");
    std::size_t begin = 0;
    for (std::size_t end; (end = path.find('/', begin)) != std::string_view::npos; begin = end + 1) {
        hints = merged(hints, hints_in_name(path.substr(begin, end - begin), NamePart::folder));
        hints = merged(hints, folder_says(path.substr(0, end)));
    }
    return merged(hints, hints_in_name(path.substr(begin), NamePart::file));
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
            throw std::runtime_error("hints: of another version");
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
