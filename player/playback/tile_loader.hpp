#pragma once

#include "base/state/zoom_field.hpp"
#include "player/playback/sample.hpp"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace vitrine::player {

/// The files of one tile, with a number that the caller chooses.
struct TileFile {
    std::uint64_t number = 0;
    std::string file;
    std::string to_coarser;  // files of its zoom fields; empty: none
    std::string to_finer;
};

struct LoadedTile {
    std::uint64_t number = 0;
    Sample sample;                        // without pixels if the file cannot be read
    std::optional<ZoomField> to_coarser;  // none: it cannot be read, or there is none
    std::optional<ZoomField> to_finer;
};

/// Reads a tile from its files.
LoadedTile load_tile(const TileFile& tile);

/// Thread-safe. Reads the tiles of a tapestry on a thread of its own, so that no frame waits for one. Stops
/// while too many tiles wait to be taken.
class TileLoader {
  public:
    TileLoader();
    TileLoader(const TileLoader&) = delete;
    TileLoader& operator=(const TileLoader&) = delete;
    TileLoader(TileLoader&&) = delete;
    TileLoader& operator=(TileLoader&&) = delete;
    ~TileLoader();

    /// Asks for these tiles, the most urgent first. They replace all that were asked for before.
    void want(std::vector<TileFile> files);

    /// Takes tiles that have been read. @param max_tiles  limit of their number
    std::vector<LoadedTile> take(std::size_t max_tiles);

    /// Limit of the tiles that wait to be taken.
    static constexpr std::size_t max_waiting = 8;

  private:
    void run();

    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<TileFile> wanted_;          // guarded by mutex_; the most urgent last
    std::optional<std::uint64_t> reading_;  // guarded by mutex_
    std::deque<LoadedTile> loaded_;         // guarded by mutex_
    bool is_stopping_ = false;              // guarded by mutex_
    std::thread thread_;                    // last: it uses all members above
};

}  // namespace vitrine::player
