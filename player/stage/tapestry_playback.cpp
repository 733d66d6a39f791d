#include "player/stage/tapestry_playback.hpp"

#include "base/system/log.hpp"

#include <array>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int tile_bits = 32;           // of its number, below its level
constexpr double rows_of_bricks = 1.5;  // that a strip is high: two, at three quarters of their height
constexpr std::array<std::byte, 4> white{std::byte{255}, std::byte{255}, std::byte{255}, std::byte{255}};

std::uint64_t number_of(const TileId& tile) {
    return (std::uint64_t{tile.level} << tile_bits) + static_cast<std::uint64_t>(tile.tile);
}

TileId tile_of(std::uint64_t number) {
    return {number >> tile_bits, static_cast<int>(number & 0xffffffff)};
}

/// Its film is the one that the record names, wherever it was when it was woven.
TapestryShow strip_of(const std::filesystem::path& directory, Vec2 canvas, const StripStageOptions& options) {
    Tapestry tapestry = read_tapestry(directory);
    if (tapestry.levels.empty()) throw std::runtime_error("'" + directory.string() + "' has no level yet");
    Vec2 picture{static_cast<double>(tapestry.brick_width), tapestry.height / rows_of_bricks};
    TapestrySettings settings{.first_source = options.first_source,
                              .patience = options.patience,
                              .shots = {},
                              .plays_at_once = options.film.has_value(),
                              .first_seen = options.first_seen};
    if (options.film) {
        tapestry.path = options.film->path;
        picture = {static_cast<double>(options.film->width), static_cast<double>(options.film->height)};
        settings.shots = options.film->shots;
    }
    return {std::move(tapestry), picture, canvas, settings};
}

std::shared_ptr<const ZoomMesh> mesh_of(const std::optional<ZoomField>& field, double left,
                                        bool is_to_finer) {
    if (!field) return nullptr;
    return std::make_shared<const ZoomMesh>(zoom_mesh(*field, left, is_to_finer));
}

}  // namespace

bool is_woven_from(const Tapestry& tapestry, const MediaRecord& film) {
    return tapestry.bytes == film.bytes && tapestry.mtime_ns == film.mtime_ns;
}

StripStage::StripStage(std::filesystem::path directory, Vec2 canvas, StripStageOptions options)
    : directory_(std::move(directory)),
      options_(std::move(options)),
      strip_(strip_of(directory_, canvas, options_)) {}

void StripStage::set_catalogue(const RecordList& records) {
    if (!options_.film) return;
    const RecordList::Record film = records.find(options_.film->path);
    if (!film || !is_woven_from(strip_.tapestry(), *film)) return strip_.end();
    strip_.set_shots(film->shots);
}

WallStep StripStage::step(std::chrono::nanoseconds now, Renderer& renderer) {
    if (!std::exchange(has_mark_, true))
        renderer.upload(strip_.sources().mark(),
                        {.width = 1, .height = 1, .stride = white.size(), .pixels = white});
    TapestryStep step = strip_.step(now);
    WallStep done{.requests = std::move(step.requests), .retired = std::move(step.retired)};
    if (give_tiles(step.missing, renderer) && options_.awaits_tiles) {
        step = strip_.step(now);
        done.retired.insert(done.retired.end(), step.retired.begin(), step.retired.end());
    }
    done.frame = std::move(step.frame);
    return done;
}

/// True: tiles have come.
bool StripStage::give_tiles(const std::vector<TileId>& missing, Renderer& renderer) {
    if (options_.awaits_tiles) {
        for (const TileFile& file : files(missing))
            give(load_tile(file), renderer);
        return !missing.empty();
    }
    const std::vector<LoadedTile> loaded = loader_.take(most_uploads);
    for (const LoadedTile& tile : loaded)
        give(tile, renderer);
    if (missing != asked_) loader_.want(files(missing));
    asked_ = missing;
    return !loaded.empty();
}

std::vector<TileFile> StripStage::files(const std::vector<TileId>& tiles) {
    std::vector<TileFile> files;
    const Tapestry& tapestry = strip_.tapestry();
    const auto zoom = [&](const TileId& tile, bool is_to_finer) {
        const std::size_t finer = tile.level + (is_to_finer ? 1 : 0);
        if (finer >= tapestry.levels.size() || !tapestry.levels[finer].has_zoom) return std::string();
        return (directory_ / tapestry.zoom_name(tile.level, tile.tile, is_to_finer)).string();
    };
    for (const TileId& tile : tiles)
        if (!unreadable_.contains(tile))
            files.push_back({.number = number_of(tile),
                             .file = (directory_ / tapestry.tile_name(tile.level, tile.tile)).string(),
                             .to_coarser = zoom(tile, false),
                             .to_finer = zoom(tile, true)});
    return files;
}

void StripStage::give(const LoadedTile& loaded, Renderer& renderer) {
    const TileId tile = tile_of(loaded.number);
    if (loaded.sample.pixels.empty()) {
        unreadable_.insert(tile);
        log::warning("tile {} of level {} of '{}' cannot be read", tile.tile, tile.level,
                     directory_.string());
        return;
    }
    renderer.upload(strip_.sources().tile(tile), loaded.sample);
    const double left = static_cast<double>(tile.tile) * strip_.tapestry().tile_width;
    strip_.tile_ready(tile, {.to_coarser = mesh_of(loaded.to_coarser, left, false),
                             .to_finer = mesh_of(loaded.to_finer, left, true)});
}

void StripStage::forget_uploads() {
    has_mark_ = false;
    strip_.forget_tiles();
}

}  // namespace vitrine::player
