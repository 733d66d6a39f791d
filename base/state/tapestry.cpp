#include "base/state/tapestry.hpp"

#include "base/state/record.hpp"
#include "base/system/atomic_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace vitrine {

using Json = nlohmann::ordered_json;
using std::chrono::nanoseconds;

namespace {

constexpr int version = 1;
constexpr const char* index_name = "index.json";
constexpr std::size_t max_levels = 32;
constexpr std::size_t max_keyframes = 200'000;                   // in one level
constexpr int max_side = 4096;                                   // px, of a tile or a brick
constexpr int max_digit = 256;                                   // px, of a digit
constexpr int max_width = 100'000'000;                           // px, of a level
constexpr nanoseconds end_piece = std::chrono::milliseconds(1);  // least time of the strip's first half brick

void require(bool is_so, std::string_view what) {
    if (!is_so) throw std::runtime_error(fmt::format("tapestry: {}", what));
}

TapestryLevel to_level(const Json& json) {
    TapestryLevel level{
        .width = json.at("width").get<int>(), .keyframes = {}, .has_zoom = json.value("zoom", false)};
    require(level.width > 0 && level.width <= max_width, "a level's width is out of range");
    const Json& keyframes = json.at("keyframes_ns");
    require(!keyframes.empty() && keyframes.size() <= max_keyframes, "a level has no keyframes, or too many");
    for (const Json& time : keyframes)
        level.keyframes.emplace_back(time.get<std::int64_t>());
    require(std::ranges::is_sorted(level.keyframes) && level.keyframes.front().count() >= 0,
            "keyframes are not in time order");
    return level;
}

KeptSheets to_sheets(const Json& json) {
    KeptSheets kept{.width = json.at("width").get<int>(),
                    .height = json.at("height").get<int>(),
                    .columns = json.at("columns").get<int>(),
                    .rows = json.at("rows").get<int>(),
                    .times = {}};
    for (const int number : {kept.width, kept.height, kept.columns, kept.rows})
        require(number > 0 && number <= max_side, "a size of kept frames is out of range");
    require(kept.width * kept.columns <= max_side && kept.height * kept.rows <= max_side,
            "a sheet of kept frames is too large");
    const Json& times = json.at("times_ns");
    require(times.size() <= max_keyframes, "too many frames are kept");
    for (const Json& time : times)
        kept.times.emplace_back(time.get<std::int64_t>());
    require(std::ranges::is_sorted(kept.times), "kept frames are not in time order");
    return kept;
}

DigitCells to_digits(const Json& json) {
    const DigitCells digits{.width = json.at("width").get<int>(), .height = json.at("height").get<int>()};
    require(digits.width > 0 && digits.height > 0 && digits.height <= max_digit && digits.width <= max_digit,
            "the size of digits is out of range");
    return digits;
}

Json to_json(const KeptSheets& kept) {
    Json times = Json::array();
    for (const nanoseconds time : kept.times)
        times.push_back(time.count());
    return {{"width", kept.width},
            {"height", kept.height},
            {"columns", kept.columns},
            {"rows", kept.rows},
            {"times_ns", std::move(times)}};
}

bool is_folder_name(const std::string& name) {
    return !name.empty() && name.size() <= 64 &&
           name.find_first_not_of("0123456789abcdefghijklmnopqrstuvwxyz-") == std::string::npos;
}

/// The value at x of a line from (x0, y0) to (x1, y1); x lies between x0 and x1.
double between(double x, double x0, double x1, double y0, double y1) {
    return x1 > x0 ? y0 + (y1 - y0) * (x - x0) / (x1 - x0) : y0;
}

}  // namespace

int Tapestry::tiles(std::size_t level) const {
    return (levels[level].width + tile_width - 1) / tile_width;
}

std::string Tapestry::tile_name(std::size_t level, int tile) const {
    return fmt::format("{}/{}/{:06}.jpg", folder, level, tile);
}

std::string Tapestry::zoom_name(std::size_t level, int tile, bool is_to_finer) const {
    return fmt::format("{}/{}/{:06}-{}.zoom", folder, level, tile, is_to_finer ? "finer" : "coarser");
}

std::string Tapestry::sheet_name(int sheet) const {
    return fmt::format("{}/frames/{:06}.jpg", folder, sheet);
}

std::string Tapestry::digits_name() const {
    return fmt::format("{}/digits.png", folder);
}

int KeptSheets::sheets() const {
    const std::size_t one = std::max<std::size_t>(1, frames_of_a_sheet());
    return static_cast<int>((times.size() + one - 1) / one);
}

std::size_t KeptSheets::nearest(nanoseconds time) const {
    const auto after = std::ranges::lower_bound(times, time);
    if (after == times.begin()) return 0;
    const auto number = static_cast<std::size_t>(after - times.begin());
    if (after == times.end()) return number - 1;
    return *after - time < time - times[number - 1] ? number : number - 1;
}

double Tapestry::middle(std::size_t level, std::size_t keyframe) const {
    if (levels[level].keyframes.size() == 1) return levels[level].width / 2.0;
    return (static_cast<double>(keyframe) + 1) * brick_width / 2.0;
}

nanoseconds Tapestry::keyframe_time(std::size_t level, std::size_t keyframe) const {
    const nanoseconds piece = std::min(end_piece, duration / 4);
    return std::clamp(levels[level].keyframes[keyframe], piece, duration - piece);
}

double Tapestry::x_at(std::size_t level, nanoseconds time) const {
    const auto& keyframes = levels[level].keyframes;
    const nanoseconds piece = std::min(end_piece, duration / 4);
    const auto drawn = [&](nanoseconds keyframe) { return std::clamp(keyframe, piece, duration - piece); };
    const auto after =
        static_cast<std::size_t>(std::ranges::upper_bound(keyframes, time, {}, drawn) - keyframes.begin());
    const bool is_first = after == 0;
    const bool is_last = after == keyframes.size();
    const nanoseconds from = is_first ? nanoseconds(0) : keyframe_time(level, after - 1);
    const nanoseconds to = is_last ? duration : keyframe_time(level, after);
    return between(static_cast<double>(std::clamp(time, nanoseconds(0), duration).count()),
                   static_cast<double>(from.count()), static_cast<double>(to.count()),
                   is_first ? 0 : middle(level, after - 1),
                   is_last ? levels[level].width : middle(level, after));
}

nanoseconds Tapestry::time_at(std::size_t level, double x) const {
    const auto& keyframes = levels[level].keyframes;
    x = std::clamp<double>(x, 0, levels[level].width);
    std::size_t after = 0;
    if (keyframes.size() == 1)
        after = x < middle(level, 0) ? 0 : 1;
    else
        after = std::min(static_cast<std::size_t>(2 * x / brick_width), keyframes.size());
    const bool is_first = after == 0;
    const bool is_last = after == keyframes.size();
    return nanoseconds(static_cast<std::int64_t>(between(
        x, is_first ? 0 : middle(level, after - 1), is_last ? levels[level].width : middle(level, after),
        is_first ? 0 : static_cast<double>(keyframe_time(level, after - 1).count()),
        static_cast<double>((is_last ? duration : keyframe_time(level, after)).count()))));
}

std::string to_json(const Tapestry& tapestry) {
    Json levels = Json::array();
    for (const TapestryLevel& level : tapestry.levels) {
        Json times = Json::array();
        for (const nanoseconds time : level.keyframes)
            times.push_back(time.count());
        levels.push_back(
            {{"width", level.width}, {"zoom", level.has_zoom}, {"keyframes_ns", std::move(times)}});
    }
    Json json{{"version", version},
              {"path", tapestry.path},
              {"bytes", tapestry.bytes},
              {"mtime_ns", tapestry.mtime_ns},
              {"duration_ns", tapestry.duration.count()},
              {"complete", tapestry.is_complete},
              {"folder", tapestry.folder},
              {"height", tapestry.height},
              {"tile_width", tapestry.tile_width},
              {"brick_width", tapestry.brick_width},
              {"levels", std::move(levels)}};
    if (!tapestry.choice.empty()) json["choice"] = tapestry.choice;
    if (!tapestry.kept.is_empty()) json["frames"] = to_json(tapestry.kept);
    if (tapestry.digits.width > 0)
        json["digits"] = {{"width", tapestry.digits.width}, {"height", tapestry.digits.height}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Tapestry tapestry_from_json(std::string_view text) {
    const Json json = Json::parse(text);
    require(json.at("version").get<int>() == version, "unknown version");
    Tapestry tapestry{.path = json.at("path").get<std::string>(),
                      .bytes = json.at("bytes").get<std::uint64_t>(),
                      .mtime_ns = json.at("mtime_ns").get<std::int64_t>(),
                      .choice = json.value("choice", ""),
                      .duration = nanoseconds(json.at("duration_ns").get<std::int64_t>()),
                      .is_complete = json.at("complete").get<bool>(),
                      .folder = json.at("folder").get<std::string>(),
                      .height = json.at("height").get<int>(),
                      .tile_width = json.at("tile_width").get<int>(),
                      .brick_width = json.at("brick_width").get<int>(),
                      .levels = {}};
    require(is_folder_name(tapestry.folder), "'folder' is not a plain name");
    for (const int side : {tapestry.height, tapestry.tile_width, tapestry.brick_width})
        require(side > 0 && side <= max_side, "a size is out of range");
    require(json.at("levels").size() <= max_levels, "too many levels");
    for (const Json& level : json.at("levels"))
        tapestry.levels.push_back(to_level(level));
    if (json.contains("frames")) tapestry.kept = to_sheets(json.at("frames"));
    if (json.contains("digits")) tapestry.digits = to_digits(json.at("digits"));
    return tapestry;
}

Tapestry read_tapestry(const std::filesystem::path& directory) {
    const std::filesystem::path file = directory / index_name;
    const std::string text = read_file(file);
    try {
        return tapestry_from_json(text);
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("read '{}': {}", file.string(), error.what()));
    }
}

std::filesystem::path tapestry_folder(const std::filesystem::path& state, const std::string& path) {
    return state / "tapestry" / record_id(path);
}

void write_tapestry(const std::filesystem::path& directory, const Tapestry& tapestry) {
    replace_file(directory / index_name, to_json(tapestry));
}

}  // namespace vitrine
