#include "base/state/keyframe_notes.hpp"

#include "base/state/path_text.hpp"
#include "base/system/atomic_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <exception>
#include <stdexcept>

namespace vitrine {

using Json = nlohmann::ordered_json;

namespace {

constexpr int notes_version = 1;
constexpr std::size_t max_notes_bytes = 16U << 20;

KeyframeNotes notes_in(const std::string& text) {
    const Json json = Json::parse(text);
    KeyframeNotes notes;
    if (json.at("version").get<int>() != notes_version) return notes;
    for (const Json& film : json.at("films")) {
        if (notes.size() == max_keyframe_notes) break;
        const std::string path = film.contains("path_hex") ? from_hex(film.at("path_hex").get<std::string>())
                                                           : film.at("path").get<std::string>();
        notes[path] = film.at("keyframes").get<std::string>();
    }
    return notes;
}

std::string to_json(const KeyframeNotes& notes) {
    Json films = Json::array();
    for (const auto& [path, text] : notes) {
        Json film{{"path", path}};
        if (!is_utf8(path)) film["path_hex"] = to_hex(path);
        film["keyframes"] = text;
        films.push_back(std::move(film));
    }
    const Json json{{"version", notes_version}, {"films", std::move(films)}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

KeyframeNotes read_keyframe_notes(const std::filesystem::path& state) {
    try {
        return notes_in(read_file(state / keyframe_notes_file, max_notes_bytes));
    } catch (const std::exception&) {  // loading one record: there is no such file, or it holds no notes
        return {};
    }
}

void write_keyframe_note(const std::filesystem::path& state, const std::string& path,
                         const std::string& text) {
    KeyframeNotes notes = read_keyframe_notes(state);
    if (text.empty())
        notes.erase(path);
    else
        notes[path] = text;
    if (notes.size() > max_keyframe_notes)
        throw std::runtime_error(
            fmt::format("keyframes are chosen for {} films already", max_keyframe_notes));
    replace_file(state / keyframe_notes_file, to_json(notes));
}

}  // namespace vitrine
