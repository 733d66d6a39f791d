#include "player/stage/tapestry_playback.hpp"

#include "base/system/log.hpp"
#include "player/scene/tapestry/kept_frames.hpp"

#include <array>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int tile_bits = 32;  // bits of a tile's number below its level
/// A tapestry's height in bricks: it has two rows, three quarters of a brick apart.
constexpr double rows_of_bricks = 1.5;
constexpr std::array<std::byte, 4> white{std::byte{255}, std::byte{255}, std::byte{255}, std::byte{255}};

std::uint64_t number_of(const TileId& tile) {
    return (std::uint64_t{tile.level} << tile_bits) + static_cast<std::uint64_t>(tile.tile);
}

TileId tile_of(std::uint64_t number) {
    return {number >> tile_bits, static_cast<int>(number & 0xffffffff)};
}

/// The film of a tapestry as its record has it. Without a record, its picture has the shape of a brick.
/// The path is that of the record, because the film may have moved since the tapestry was woven.
PreviewedFilm film_of(const Tapestry& tapestry, const RecordList::Record& record) {
    PreviewedFilm film{
        .path = tapestry.path,
        .duration = tapestry.duration,
        .picture = {static_cast<double>(tapestry.brick_width), tapestry.height / rows_of_bricks},
        .shots = {}};
    if (!record) return film;
    const Box active = active_picture(*record);
    film.path = record->path;
    film.picture = active.max - active.min;
    film.active = {{active.min.x / record->width, active.min.y / record->height},
                   {active.max.x / record->width, active.max.y / record->height}};
    film.shots = record->shots;
    return film;
}

TapestryShow show_of(const std::filesystem::path& directory, Vec2 canvas,
                     const TapestryPlaybackOptions& options) {
    Tapestry tapestry = read_tapestry(directory);
    if (tapestry.levels.empty()) throw std::runtime_error("'" + directory.string() + "' has no level yet");
    TapestrySettings settings{.first_source = options.first_source,
                              .patience = options.patience,
                              .plays_at_once = true,
                              .first_seen = options.first_seen};
    if (options.rests) settings.pace.patience = std::chrono::nanoseconds::max();
    PreviewedFilm film = film_of(tapestry, options.film);
    return {std::move(tapestry), std::move(film), canvas, settings};
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

TapestryPlayback::TapestryPlayback(std::filesystem::path directory, Vec2 canvas,
                                   TapestryPlaybackOptions options)
    : directory_(std::move(directory)),
      options_(std::move(options)),
      show_(show_of(directory_, canvas, options_)) {}

void TapestryPlayback::set_catalogue(const RecordList& records) {
    const RecordList::Record film = records.find(show_.film().path);
    const bool is_known = film && is_woven_from(show_.tapestry(), *film);
    if (!is_known && !options_.film) return;
    if (!is_known) return show_.end();
    options_.film = film;
    show_.set_film(film_of(show_.tapestry(), film));
}

WallStep TapestryPlayback::step(std::chrono::nanoseconds now, Renderer& renderer) {
    if (!std::exchange(has_mark_, true))
        renderer.upload(show_.sources().mark(),
                        {.width = 1, .height = 1, .stride = white.size(), .pixels = white});
    TapestryStep step = show_.step(now);
    WallStep done{.requests = std::move(step.requests), .retired = std::move(step.retired)};
    if (give_tiles(step.missing, renderer) && options_.awaits_tiles) {
        step = show_.step(now);
        done.retired.insert(done.retired.end(), step.retired.begin(), step.retired.end());
    }
    done.frame = std::move(step.frame);
    return done;
}

/// Gives tiles that have been read to the renderer. True: at least one.
bool TapestryPlayback::give_tiles(const std::vector<TileId>& missing, Renderer& renderer) {
    if (options_.awaits_tiles) {
        for (const TileFile& file : files(missing))
            give(load_tile(file), renderer);
        return !missing.empty();
    }
    const std::vector<LoadedTile> loaded = loader_.take(max_uploads);
    for (const LoadedTile& tile : loaded)
        give(tile, renderer);
    if (missing != asked_) loader_.want(files(missing));
    asked_ = missing;
    return !loaded.empty();
}

std::vector<TileFile> TapestryPlayback::files(const std::vector<TileId>& tiles) {
    std::vector<TileFile> files;
    const Tapestry& tapestry = show_.tapestry();
    const auto zoom = [&](const TileId& tile, bool is_to_finer) {
        const std::size_t finer = tile.level + (is_to_finer ? 1 : 0);
        if (finer >= tapestry.levels.size() || !tapestry.levels[finer].has_zoom) return std::string();
        return (directory_ / tapestry.zoom_name(tile.level, tile.tile, is_to_finer)).string();
    };
    for (const TileId& tile : tiles)
        if (!unreadable_.contains(tile))
            files.push_back({.number = number_of(tile),
                             .file = (directory_ / file_of(tapestry, tile)).string(),
                             .to_coarser = zoom(tile, false),
                             .to_finer = zoom(tile, true)});
    return files;
}

void TapestryPlayback::give(const LoadedTile& loaded, Renderer& renderer) {
    const TileId tile = tile_of(loaded.number);
    if (loaded.sample.pixels.empty()) {
        unreadable_.insert(tile);
        log::warning("tile {} of level {} of '{}' cannot be read", tile.tile, tile.level,
                     directory_.string());
        return;
    }
    renderer.upload(show_.sources().tile(tile), loaded.sample);
    const double left = static_cast<double>(tile.tile) * show_.tapestry().tile_width;
    show_.tile_ready(tile, {.to_coarser = mesh_of(loaded.to_coarser, left, false),
                            .to_finer = mesh_of(loaded.to_finer, left, true)});
}

void TapestryPlayback::forget_uploads() {
    has_mark_ = false;
    show_.forget_tiles();
}

}  // namespace vitrine::player
