#include "player/playback/tile_loader.hpp"

#include "base/media/still_picture.hpp"
#include "base/system/atomic_file.hpp"

#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int max_side = 4096;  // px of a tile

constexpr std::size_t max_field_bytes = std::size_t{1} << 20;

Sample load_picture(const std::string& file) {
    try {
        const auto picture = std::make_shared<const StillPicture>(load_still(file, max_side, max_side));
        return {.width = picture->width,
                .height = picture->height,
                .stride = std::size_t{4} * static_cast<std::size_t>(picture->width),
                .pixels = picture->pixels,
                .owner = picture};
    } catch (const std::exception&) {  // a coarser level is shown in its place
        return {};
    }
}

std::optional<ZoomField> load_field(const std::string& file) {
    if (file.empty()) return std::nullopt;
    try {
        return zoom_field_from_bytes(read_file(file, max_field_bytes));
    } catch (const std::exception&) {  // without it the tile is left out during a zoom
        return std::nullopt;
    }
}

}  // namespace

LoadedTile load_tile(const TileFile& tile) {
    return {.number = tile.number,
            .sample = load_picture(tile.file),
            .to_coarser = load_field(tile.to_coarser),
            .to_finer = load_field(tile.to_finer)};
}

TileLoader::TileLoader() : thread_([this] { run(); }) {}

TileLoader::~TileLoader() {
    {
        const std::lock_guard lock(mutex_);
        is_stopping_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void TileLoader::want(std::vector<TileFile> files) {
    std::ranges::reverse(files);
    {
        const std::lock_guard lock(mutex_);
        std::erase_if(files, [&](const TileFile& file) {
            return file.number == reading_ || std::ranges::any_of(loaded_, [&](const LoadedTile& tile) {
                       return tile.number == file.number;
                   });
        });
        wanted_ = std::move(files);
    }
    wake_.notify_one();
}

std::vector<LoadedTile> TileLoader::take(std::size_t max_tiles) {
    std::vector<LoadedTile> tiles;
    {
        const std::lock_guard lock(mutex_);
        for (; !loaded_.empty() && tiles.size() < max_tiles; loaded_.pop_front())
            tiles.push_back(std::move(loaded_.front()));
    }
    wake_.notify_one();
    return tiles;
}

void TileLoader::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock,
                   [this] { return is_stopping_ || (!wanted_.empty() && loaded_.size() < max_waiting); });
        if (is_stopping_) return;
        const TileFile file = std::move(wanted_.back());
        wanted_.pop_back();
        reading_ = file.number;
        lock.unlock();
        LoadedTile tile = load_tile(file);
        lock.lock();
        reading_.reset();
        loaded_.push_back(std::move(tile));
    }
}

}  // namespace vitrine::player
