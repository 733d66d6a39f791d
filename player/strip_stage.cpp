#include "player/strip_stage.hpp"

#include "base/system/log.hpp"

#include <array>
#include <utility>

namespace vitrine {

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

Tapestry checked(const std::filesystem::path& directory) {
    Tapestry tapestry = read_tapestry(directory);
    if (tapestry.levels.empty()) throw std::runtime_error("'" + directory.string() + "' has no level yet");
    return tapestry;
}

Vec2 picture_of(const std::filesystem::path& directory) {
    const Tapestry tapestry = read_tapestry(directory);
    return {static_cast<double>(tapestry.brick_width), tapestry.height / rows_of_bricks};
}

}  // namespace

StripStage::StripStage(std::filesystem::path directory, std::optional<Vec2> picture, Vec2 canvas,
                       const StripStageOptions& options)
    : directory_(std::move(directory)),
      options_(options),
      strip_(checked(directory_), picture ? *picture : picture_of(directory_), canvas,
             {.first_source = options.first_source, .patience = options.patience}) {}

WallStep StripStage::step(std::chrono::nanoseconds now, Renderer& renderer) {
    if (!std::exchange(has_mark_, true))
        renderer.upload(strip_.mark(), {.width = 1, .height = 1, .stride = white.size(), .pixels = white});
    StripStep step = strip_.step(now);
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
            give({file.number, load_tile(file.file)}, renderer);
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
    for (const TileId& tile : tiles)
        if (!unreadable_.contains(tile))
            files.push_back({number_of(tile),
                             (directory_ / strip_.tapestry().tile_name(tile.level, tile.tile)).string()});
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
    renderer.upload(strip_.source_of(tile), loaded.sample);
    strip_.tile_ready(tile);
}

void StripStage::forget_uploads() {
    has_mark_ = false;
    strip_.forget_tiles();
}

}  // namespace vitrine
