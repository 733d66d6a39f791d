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

/// The files of one tile, with a number of the caller's.
struct TileFile {
    std::uint64_t number = 0;
    std::string file;
    std::string to_coarser;  // files of its zoom fields; empty: there is none
    std::string to_finer;
};

struct LoadedTile {
    std::uint64_t number = 0;
    Sample sample;                        // without pixels where the file cannot be read
    std::optional<ZoomField> to_coarser;  // none: it cannot be read, or there is none
    std::optional<ZoomField> to_finer;
};

/// Reads a tile from its files.
LoadedTile load_tile(const TileFile& tile);

/// Thread-safe. Reads the tiles of a tapestry on a thread of its own, so that no frame waits for one. Stops
/// reading while too many tiles wait to be taken.
class TileLoader {
  public:
    TileLoader();
    TileLoader(const TileLoader&) = delete;
    TileLoader& operator=(const TileLoader&) = delete;
    TileLoader(TileLoader&&) = delete;
    TileLoader& operator=(TileLoader&&) = delete;
    ~TileLoader();

    /// Asks for these tiles, the most urgent first, in place of all that were asked for before.
    void want(std::vector<TileFile> files);

    /// Tiles that have been read since. @param most  of them
    std::vector<LoadedTile> take(std::size_t most);

    /// Tiles that lie ready to be taken, at most.
    static constexpr std::size_t most_waiting = 8;

  private:
    void run();

    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<TileFile> wanted_;          // guarded by mutex_; the most urgent last
    std::optional<std::uint64_t> reading_;  // guarded by mutex_
    std::deque<LoadedTile> loaded_;         // guarded by mutex_
    bool is_stopping_ = false;              // guarded by mutex_
    std::thread thread_;                    // last: runs on all of the above
};

}  // namespace vitrine::player
