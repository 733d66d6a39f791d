#pragma once

#include "player/playback/governor.hpp"
#include "player/playback/playing_shot.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/shot_request.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// The sources of what is on the wall and of what comes next. Reading and ending happen in the background, a
/// few at a time; a source that hangs, of a share that has gone, does not keep the others waiting for good.
class SourcePool {
  public:
    explicit SourcePool(MediaPlaces places, SourceOptions options = {})
        : pool_{.places = std::move(places),
                .options = std::move(options),
                .before_opening = {},
                .ending = {}} {}

    /// The decoding of films by sources to come.
    FilmOptions& film_options() { return pool_.options.film; }

    /// Calls `call` with the path of each file, below the media folder, before anything of it is read.
    void set_before_opening(std::function<void(const std::string& path)> call) {
        pool_.before_opening = std::move(call);
    }

    /// The files that are being read or played.
    std::set<std::string> open_files() const;

    /// Asks for a new source, or for another size of one there is. A film that plays from the media folder
    /// and is in the store by now goes over to the clip at the end of a loop.
    void request(const ShotRequest& request);

    /// The source is not needed any more; it ends in the background.
    void retire(SourceId source);

    /// Retires every source and returns the ids of those that were being read or played.
    std::vector<SourceId> retire_all();

    /// From now on update() and wait_until_ready() tell the listener the news of its owner's sources, for as
    /// long as the listener exists.
    void listen(std::weak_ptr<const SourceListener> listener) { listeners_.add(std::move(listener)); }

    /// Starts the sources that wait, as far as there is room, and destroys those that have ended; to be
    /// called once a frame. Photos of another size than asked for since are read anew once nothing waits, one
    /// after the other.
    /// @return the news of sources that nobody listens to
    std::vector<SourceEvent> update();

    /// Takes every source of the frame to its item's time, and each item's slide to the very picture. Where
    /// sources keep time, the films that cost more than the machine has are judged once a second
    /// (governor.hpp), and a film without a picture for two seconds is built anew (watchdog.hpp).
    void advance(Frame& frame);

    /// The picture of a source as of the last advance(); nothing before its first.
    std::optional<Sample> sample(SourceId source) const;

    /// Waits until advance() of this frame will be exact: for rendering at its own pace.
    /// False: not within `patience`.
    bool wait_for(const Frame& frame, std::chrono::nanoseconds patience);

    /// Waits until every source that was requested is ready or has failed, and returns the news of those that
    /// nobody listens to.
    std::vector<SourceEvent> wait_until_ready(std::chrono::nanoseconds patience);

    /// Pictures that were due and not there, of all sources so far.
    std::uint64_t late() const;

    /// Each source that plays or gets ready.
    std::vector<SourceState> states() const;

    /// The number of sources that were asked for and have no picture yet.
    std::size_t queue() const;

  private:
    void start_waiting(std::vector<SourceEvent>& events);
    void read_one_photo_anew();
    void open_one_clip();
    void govern(std::chrono::nanoseconds now);

    PoolState pool_;  // before its shots, which refer to it
    Governor governor_;
    std::chrono::nanoseconds judged_{0};  // when the governor was asked last
    SourceEvents listeners_;
    std::deque<ShotRequest> waiting_;
    std::map<SourceId, PlayingShot> playing_;
};

}  // namespace vitrine::player
