#include "player/content/arrangement_files.hpp"

#include "base/state/path_text.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <system_error>

namespace vitrine::player {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr int arrangement_version = 1;
constexpr std::size_t max_walls = 64;
constexpr std::size_t max_shots = 2000;      // of a wall
constexpr std::size_t max_listed = 100'000;  // pinned and removed files
constexpr double max_length = 1 << 20;       // canvas px
constexpr double max_factor = 1 << 14;       // canvas px per source px

/// Adds a path, which may have any bytes.
void put_path(Json& json, const std::string& key, const std::string& path) {
    json[key] = path;
    if (!is_utf8(path)) json[key + "_hex"] = to_hex(path);
}

std::string path_at(const Json& json, const std::string& key) {
    const std::string hex = key + "_hex";
    return json.contains(hex) ? from_hex(json.at(hex).get<std::string>()) : json.at(key).get<std::string>();
}

double number_at(const Json& json, const char* key, double limit) {
    const double number = json.at(key).get<double>();
    if (!(std::abs(number) <= limit)) throw std::runtime_error(fmt::format("'{}' is out of range", key));
    return number;
}

double size_at(const Json& json, const char* key, double limit) {
    const double size = number_at(json, key, limit);
    if (size <= 0) throw std::runtime_error(fmt::format("'{}' is out of range", key));
    return size;
}

/// A list of a limited length.
const Json& list_at(const Json& json, const char* key, std::size_t limit) {
    const Json& list = json.at(key);
    if (!list.is_array() || list.size() > limit)
        throw std::runtime_error(fmt::format("'{}' is no list of at most {}", key, limit));
    return list;
}

Json shot_json(const SlotShot& shot) {
    Json json{{"slot", shot.slot}};
    put_path(json, "path", shot.key.path);
    json["shot"] = shot.key.shot;
    if (!shot.folder.empty()) put_path(json, "folder", shot.folder);
    json.update({{"scale", shot.at.scale},
                 {"x", shot.at.offset.x},
                 {"y", shot.at.offset.y},
                 {"seat", {{"x", shot.seat.centre.x}, {"y", shot.seat.centre.y}, {"area", shot.seat.area}}}});
    return json;
}

SlotShot shot_from(const Json& json) {
    SlotShot shot{.slot = static_cast<int>(number_at(json, "slot", max_shots)),
                  .key = {path_at(json, "path"), static_cast<int>(number_at(json, "shot", max_listed))}};
    if (json.contains("folder")) shot.folder = path_at(json, "folder");
    shot.at = {size_at(json, "scale", max_factor),
               {number_at(json, "x", max_length), number_at(json, "y", max_length)}};
    const Json& seat = json.at("seat");
    shot.seat = {{number_at(seat, "x", max_length), number_at(seat, "y", max_length)},
                 number_at(seat, "area", max_length * max_length)};
    if (shot.slot < 0 || shot.key.shot < 0) throw std::runtime_error("a number is negative");
    return shot;
}

Json wall_json(const std::string& folder, const ArrangedWall& wall) {
    Json json = Json::object();
    put_path(json, "outputs_folder", folder);
    json.update({{"width", wall.canvas.x}, {"height", wall.canvas.y}, {"shots", Json::array()}});
    for (const SlotShot& shot : wall.shots)
        json["shots"].push_back(shot_json(shot));
    return json;
}

ArrangedWall wall_from(const Json& json) {
    ArrangedWall wall{.canvas = {size_at(json, "width", max_length), size_at(json, "height", max_length)},
                      .shots = {}};
    for (const Json& shot : list_at(json, "shots", max_shots))
        wall.shots.push_back(shot_from(shot));
    return wall;
}

WallArrangement arrangement_from(const Json& json) {
    if (json.at("version").get<int>() != arrangement_version)
        throw std::runtime_error("it is of another version");
    WallArrangement arrangement;
    for (const Json& wall : list_at(json, "walls", max_walls))
        arrangement.walls[path_at(wall, "outputs_folder")] = wall_from(wall);
    for (const Json& file : list_at(json, "pinned", max_listed))
        arrangement.pinned.insert(path_at(file, "path"));
    for (const Json& slot : list_at(json, "pinned_slots", max_shots))
        arrangement.slots.insert(slot.get<int>());
    for (const Json& file : list_at(json, "removed", max_listed))
        arrangement.removed.push_back({.path = path_at(file, "path"),
                                       .bytes = file.at("bytes").get<std::uint64_t>(),
                                       .mtime_ns = file.at("mtime_ns").get<std::int64_t>()});
    return arrangement;
}

}  // namespace

std::string arrangement_json(const WallArrangement& arrangement) {
    Json json{{"version", arrangement_version}, {"walls", Json::array()}, {"pinned", Json::array()}};
    for (const auto& [folder, wall] : arrangement.walls)
        json["walls"].push_back(wall_json(folder, wall));
    for (const std::string& path : arrangement.pinned)
        put_path(json["pinned"].emplace_back(Json::object()), "path", path);
    json["pinned_slots"] = arrangement.slots;
    json["removed"] = Json::array();
    for (const RemovedFile& file : arrangement.removed) {
        Json& entry = json["removed"].emplace_back(Json::object());
        put_path(entry, "path", file.path);
        entry.update({{"bytes", file.bytes}, {"mtime_ns", file.mtime_ns}});
    }
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

WallArrangement arrangement_from_json(const std::string& text) {
    try {
        return arrangement_from(Json::parse(text));
    } catch (const Json::exception& error) {
        throw std::runtime_error(error.what());
    }
}

bool is_arrangement_name(std::string_view name) {
    constexpr std::size_t longest = 64;
    constexpr std::string_view marks = "-_.";
    const auto is_alphanumeric = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    };
    return !name.empty() && name.size() <= longest && is_alphanumeric(name.front()) &&
           std::ranges::all_of(
               name, [&](char c) { return is_alphanumeric(c) || marks.find(c) != std::string_view::npos; });
}

std::optional<WallArrangement> ArrangementFiles::last() const {
    std::error_code missing;
    if (!fs::exists(last_, missing)) return std::nullopt;
    try {
        return arrangement_from_json(read_file(last_, max_arrangement_bytes));
    } catch (const std::runtime_error& error) {  // the file is damaged: the wall is made as if there was none
        log::warning("'{}' is ignored: {}", last_.string(), error.what());
        return std::nullopt;
    }
}

void ArrangementFiles::write_last(const WallArrangement& arrangement) const {
    replace_file(last_, arrangement_json(arrangement));
}

fs::path ArrangementFiles::file_of(const std::string& name) const {
    if (!is_arrangement_name(name))
        throw std::runtime_error(
            "the name of a layout has up to 64 letters, digits, '-', '_' and '.', and begins with a letter "
            "or a digit");
    return folder_ / (name + ".json");
}

void ArrangementFiles::save(const std::string& name, const WallArrangement& arrangement) const {
    const fs::path file = file_of(name);
    std::error_code missing;
    if (!fs::exists(file, missing) && names().size() >= max_named)
        throw std::runtime_error(fmt::format("there are {} layouts; forget one first", max_named));
    fs::create_directories(folder_);
    replace_file(file, arrangement_json(arrangement));
}

WallArrangement ArrangementFiles::load(const std::string& name) const {
    const fs::path file = file_of(name);
    std::error_code missing;
    if (!fs::exists(file, missing)) {
        const std::vector<std::string> known = names();
        throw std::runtime_error(fmt::format(
            "there is no layout '{}'; {}", name,
            known.empty() ? "none has been saved" : fmt::format("saved: {}", fmt::join(known, ", "))));
    }
    try {
        return arrangement_from_json(read_file(file, max_arrangement_bytes));
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("'{}' cannot be read: {}", file.string(), error.what()));
    }
}

void ArrangementFiles::forget(const std::string& name) const {
    const fs::path file = file_of(name);
    std::error_code error;
    if (!fs::remove(file, error))
        throw std::runtime_error(
            error ? fmt::format("'{}' cannot be removed: {}", file.string(), error.message())
                  : fmt::format("there is no layout '{}'", name));
}

std::vector<std::string> ArrangementFiles::names() const {
    std::vector<std::string> names;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, missing)) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() == ".json" && is_arrangement_name(name)) names.push_back(name);
    }
    std::ranges::sort(names);
    return names;
}

}  // namespace vitrine::player
