#pragma once

#include "player/playback/governor.hpp"
#include "player/playback/playing_shot.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/shot_request.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// The sources of the shots on the wall and of those that come next. Sources are read and ended in the
/// background, a few at a time. A source that hangs, such as one on a lost network share, does not block the
/// others for good.
class SourcePool {
  public:
    explicit SourcePool(MediaPlaces places, SourceOptions options = {})
        : pool_{.places = std::move(places), .options = std::move(options), .tell_file = {}, .ending = {}} {}

    /// The options for decoding films, used by new sources.
    FilmOptions& film_options() { return pool_.options.film; }

    /// Sets a function that is called before each file is read, and when a file has made its reader crash.
    void listen_to_files(FileListener call) { pool_.tell_file = std::move(call); }

    /// The files that are being read or played.
    std::set<std::string> open_files() const;

    /// Asks for a new source, or for another size of an existing one. A film that plays from the media folder
    /// and is in the store by now changes to the clip at the end of a loop.
    void request(const ShotRequest& request);

    /// Ends the source in the background: it is not needed any more.
    void retire(SourceId source);

    /// Retires every source and returns the ids of those that were being read or played.
    std::vector<SourceId> retire_all();

    /// Adds a listener, for as long as it exists: update() and wait_until_ready() report to it the news of
    /// its owner's sources.
    void listen(std::weak_ptr<const SourceListener> listener) { listeners_.add(std::move(listener)); }

    /// Starts waiting sources, as far as there is room, and destroys those that have ended. Call once a
    /// frame. When no source waits, photos whose size has changed are read again, one after another.
    /// @return the news of sources without a listener
    std::vector<SourceEvent> update();

    /// Takes every source of the frame to its item's time. If sources keep time, films that cost too much are
    /// judged once a second (governor.hpp), and a film without a picture for two seconds is rebuilt
    /// (watchdog.hpp).
    void advance(const Frame& frame);

    /// The picture of a source as of the last advance(). None: it had no picture yet.
    std::optional<Sample> sample(SourceId source) const;

    /// Waits until advance() of this frame will be exact: for rendering at its own pace.
    /// False: not within `patience`.
    bool wait_for(const Frame& frame, std::chrono::nanoseconds patience);

    /// Waits until every requested source is ready or has failed. @return the news of sources without a
    /// listener
    std::vector<SourceEvent> wait_until_ready(std::chrono::nanoseconds patience);

    /// The number of pictures that were missing when due, of all sources so far.
    std::uint64_t late() const;

    /// All sources that play or prepare.
    std::vector<SourceState> states() const;

    /// The number of requested sources without a picture.
    std::size_t queue() const;

  private:
    void start_waiting(std::vector<SourceEvent>& events);
    void read_one_photo_anew();
    void open_one_clip();
    void govern(std::chrono::nanoseconds now);

    PoolState pool_;  // before its shots, which refer to it
    Governor governor_;
    std::chrono::nanoseconds judged_{0};  // time of the governor's last judgement
    SourceEvents listeners_;
    std::deque<ShotRequest> waiting_;
    std::map<SourceId, PlayingShot> playing_;
};

}  // namespace vitrine::player
