#pragma once

#include "base/state/blame.hpp"
#include "player/playback/clip_handover.hpp"
#include "player/playback/governor.hpp"
#include "player/playback/media_places.hpp"
#include "player/playback/shot_source.hpp"
#include "player/playback/source_events.hpp"
#include "player/playback/watchdog.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/shot_request.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// The present state of a source, for reports.
struct SourceState {
    SourceId source = 0;
    std::string path;
    bool is_film = false;
    Detail detail = Detail::all;  // a film's; all for a photo
    bool is_stored = false;       // played from the store
    bool is_ready = false;
    std::uint64_t late = 0;  // pictures that were missing when due
};

/// @param path  below the media folder
using FileListener = std::function<void(const std::string& path, FileNews news)>;

/// The state that all shots of a pool share.
struct PoolState {
    MediaPlaces places;
    SourceOptions options;                            // for new sources
    FileListener tell_file;                           // empty: nobody listens
    std::vector<std::unique_ptr<ShotSource>> ending;  // destroyed once their threads have ended
    std::uint64_t late = 0;  // late pictures of sources that were replaced or retired
};

/// One shot for as long as it is asked for. Keeps it playing if its stored copy is damaged, a hardware
/// decoder fails or the film stands still. Hands it over to its clip.
class PlayingShot {
  public:
    /// Starts to read.
    /// @param pool  outlives this
    PlayingShot(ShotRequest request, PoolState& pool);

    const ShotRequest& request() const { return request_; }

    ShotSource& source() const { return *source_; }

    SourceState state() const;

    /// True until collect_events() has reported that it is ready or has failed.
    bool is_preparing() const { return !is_told_ready_ && !is_told_failed_; }

    /// True if it has been preparing for so long that others need not wait for it.
    bool is_stuck() const;

    /// Sets another size, or a clip that the store has got since.
    void change_request(const ShotRequest& request);

    /// Appends the news since the last call. If the source has failed, starts the shot from another file or
    /// in software.
    void collect_events(std::vector<SourceEvent>& events);

    /// Goes to the item's time. If sources keep time, a film without a picture for two seconds is rebuilt
    /// (watchdog.hpp).
    void advance(const DrawItem& item, const Frame& frame);

    /// The picture as of the last advance().
    const std::optional<Sample>& sample() const { return sample_; }

    /// Waits until advance() to this time will be exact. False: not within `patience`.
    bool wait_for(std::chrono::nanoseconds local, std::chrono::nanoseconds patience);

    bool is_clip_wanted() const;

    bool has_clip() const { return handover_.has_clip(); }

    /// Opens the clip for the end of a loop. @pre is_clip_wanted()
    void open_clip();

    /// The cost of a film that was shown since that time. None: a photo, a film that was not shown, or one
    /// that stands still.
    std::optional<FilmLoad> measure_load(std::chrono::nanoseconds since, std::chrono::nanoseconds now);

    /// Ends the sources in the background. Call nothing else afterwards.
    void retire();

  private:
    void start(bool may_be_stored, std::chrono::nanoseconds at);
    void take_clip();
    void rebuild();
    void watch(std::chrono::nanoseconds now);

    PoolState& pool_;  // outlives this
    ShotRequest request_;
    std::unique_ptr<ShotSource> source_;
    bool is_stored_ = false;    // read from the store
    bool is_software_ = false;  // decoded without hardware
    std::chrono::steady_clock::time_point opened_;
    ClipHandover handover_;
    std::chrono::nanoseconds local_{0};  // shot time of its last frame
    std::optional<Sample> sample_;
    Watchdog watchdog_;
    FilmMeter meter_;
    std::optional<std::string> given_up_;  // the reason why it is not rebuilt again
    bool is_told_ready_ = false;
    bool is_told_failed_ = false;
};

}  // namespace vitrine::player
