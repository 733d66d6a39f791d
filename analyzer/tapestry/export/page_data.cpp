#include "analyzer/tapestry/export/page_data.hpp"

#include "base/media/gst_ptr.hpp"
#include "base/system/atomic_file.hpp"

#include <fmt/format.h>
#include <glib.h>
#include <nlohmann/json.hpp>

#include <string_view>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

std::string in_base64(std::string_view bytes) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): GLib's bytes are unsigned
    const auto* begin = reinterpret_cast<const guchar*>(bytes.data());
    const GstPtr<gchar> text(g_base64_encode(begin, bytes.size()));
    return text.get();
}

/// Only ASCII: it means the same in each encoding that a page is read in. Bytes that are not UTF-8 become
/// replacement characters.
std::string index_script(const Tapestry& tapestry, const PageFilm& film) {
    Json levels = Json::array();
    for (const TapestryLevel& level : tapestry.levels) {
        Json times = Json::array();
        for (const std::chrono::nanoseconds time : level.keyframes)
            times.push_back(time.count());
        levels.push_back(
            {{"width", level.width}, {"zoom", level.has_zoom}, {"keyframes_ns", std::move(times)}});
    }
    const Json json{{"version", 1},
                    {"name", film.name},
                    {"film", {{"file", page_film_name}, {"width", film.width}, {"height", film.height}}},
                    {"duration_ns", tapestry.duration.count()},
                    {"height", tapestry.height},
                    {"tile_width", tapestry.tile_width},
                    {"brick_width", tapestry.brick_width},
                    {"levels", std::move(levels)}};
    return fmt::format("vitrine.setTapestry({});\n",
                       json.dump(-1, ' ', true, Json::error_handler_t::replace));
}

std::string tile_script(const fs::path& woven, const Tapestry& tapestry, std::size_t level, int tile) {
    const auto field = [&](bool is_there, bool is_to_finer) {
        return is_there ? in_base64(read_file(woven / tapestry.zoom_name(level, tile, is_to_finer))) : "";
    };
    const bool has_finer = level + 1 < tapestry.levels.size() && tapestry.levels[level + 1].has_zoom;
    const bool has_coarser = level > 0 && tapestry.levels[level].has_zoom;
    return fmt::format("vitrine.addTile({}, {}, \"{}\", \"{}\", \"{}\");\n", level, tile,
                       in_base64(read_file(woven / tapestry.tile_name(level, tile))), field(has_finer, true),
                       field(has_coarser, false));
}

}  // namespace

void write_page_data(const fs::path& woven, const PageFilm& film, const fs::path& folder) {
    const Tapestry tapestry = read_tapestry(woven);
    for (std::size_t level = 0; level < tapestry.levels.size(); ++level) {
        const fs::path tiles = folder / std::to_string(level);
        fs::create_directories(tiles);
        for (int tile = 0; tile < tapestry.tiles(level); ++tile)
            replace_file_unsynced(tiles / fmt::format("{:06}.js", tile),
                                  tile_script(woven, tapestry, level, tile));
    }
    replace_file(folder / "tapestry.js", index_script(tapestry, film));
}

}  // namespace vitrine::analyzer
