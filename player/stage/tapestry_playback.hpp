#pragma once

#include "player/playback/tile_loader.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/show.hpp"
#include "player/scene/tapestry/tapestry_show.hpp"
#include "player/stage/newer_index.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

struct TapestryPlaybackOptions {
    SourceId first_source = 0;                         // its sources are numbered from here on
    std::optional<std::chrono::nanoseconds> patience;  // time without a touch until it ends; none: never
    bool awaits_tiles = false;                         // each frame waits for all its tiles
    bool rests = false;                                // it never moves by itself
    RecordList::Record film;                           // none: the film has no record
    std::chrono::nanoseconds first_seen{0};            // film time in the middle of the first view
    bool awaits_index = false;          // there is no index of the film yet; then `film` is needed
    std::filesystem::path wishes_in{};  // state directory, where the analyzer hears that a visitor waits for
                                        // what is not woven yet; empty: nobody waits
    bool edits_keyframes = false;       // touches change the film's keyframes; needs `film` and `wishes_in`
    bool follows = false;               // it shows what another box shows: see follow()
    std::optional<Vec2> opened_at;      // canvas px; none: the middle of the canvas
};

/// True: the tapestry was woven from the present content of the film.
bool is_woven_from(const Tapestry& tapestry, const MediaRecord& film);

/// Tells the analyzer for as long as it exists that a visitor waits for a film's tapestry. Logs.
class TapestryWish {
  public:
    /// @param state  the state directory
    /// @param path   of the film's record
    TapestryWish(std::filesystem::path state, std::string path);
    TapestryWish(const TapestryWish&) = delete;
    TapestryWish& operator=(const TapestryWish&) = delete;
    TapestryWish(TapestryWish&&) = delete;
    TapestryWish& operator=(TapestryWish&&) = delete;
    ~TapestryWish();

  private:
    std::filesystem::path state_;
    std::string path_;
};

/// Shows a film's tapestry with its tiles. While the film is woven better and better, each newer index takes
/// the place of the one before; without any, the film plays above an empty strip for a while. Tiles are read
/// in the background and a few of them are given to the renderer with each frame, so that neither reading nor
/// uploading delays a frame. Keyframes that are chosen by touch go to the analyzer, which weaves the film
/// anew.
class TapestryPlayback {
  public:
    /// @param directory  the tapestry's directory
    /// @throws std::runtime_error, std::system_error  naming the index that cannot be read
    TapestryPlayback(std::filesystem::path directory, const TapestryRoom& room,
                     const TapestryPlaybackOptions& options);

    void set_room(const TapestryRoom& room) { show_.set_room(room); }

    void handle_gesture(const Gesture& gesture) { show_.handle_gesture(gesture); }

    void source_ready(SourceId source) { show_.source_ready(source); }

    void source_failed(SourceId source) { show_.source_failed(source); }

    /// Updates the film's record. If the film has changed, the tapestry is over.
    void set_catalogue(const RecordList& records);

    bool is_over() const { return show_.is_over(); }

    /// Ends the tapestry.
    void end() { show_.end(); }

    /// Shows the same as another box from now on. @param seen  of this film, in this show's time
    void follow(const TapestryMoment& seen);

    /// The last frame as other boxes need it.
    const TapestryMoment& seen() const { return seen_; }

    /// The next frame. Gives the tiles that it needs to the renderer. @param renderer  nullptr: there is none
    WallStep step(std::chrono::nanoseconds now, Renderer* renderer);

    /// Call after the renderer was replaced: all pictures must be uploaded again.
    void forget_uploads();

    /// Drops everything. @return the sources that it used
    std::vector<SourceId> close() { return show_.close(); }

    const TapestryShow& show() const { return show_; }

    /// Limit of the time that a visitor waits for a first view of a film that is not woven yet.
    static constexpr std::chrono::seconds max_wait{15};

    /// Limit of the tiles that the renderer gets in one frame, unless frames wait for tiles.
    static constexpr std::size_t max_uploads = 2;

  private:
    void take_newer_index(std::chrono::nanoseconds now);
    void end_waiting(std::chrono::nanoseconds now);
    void hand_over_choice();
    void add_files(const TapestryStrip& strip, const std::vector<TileId>& tiles,
                   std::vector<TileFile>& files) const;
    bool give_tiles(const TapestryStep& step, Renderer* renderer);
    void give(const LoadedTile& tile, Renderer* renderer);

    std::filesystem::path directory_;
    std::filesystem::path state_;  // see wishes_in
    bool awaits_tiles_;
    RecordList::Record film_;  // none: the film has no record
    NewerIndex index_;
    TapestryShow show_;
    std::optional<TapestryWish> wish_;                // a visitor waits
    std::optional<std::chrono::nanoseconds> opened_;  // time of the first step
    std::optional<TapestryMoment> followed_;          // the moment of another box that is shown here
    TapestryMoment seen_;                             // of the last frame
    std::set<std::uint64_t> unreadable_;              // numbers of tiles that are not asked for again
    std::vector<std::uint64_t> asked_;                // of the last tiles that the loader was asked for
    bool has_mark_ = false;                           // the renderer has the white picture for drawing lines
    TileLoader loader_;
};

}  // namespace vitrine::player
