#pragma once

#include "player/playback/governor.hpp"
#include "player/playback/media_places.hpp"
#include "player/playback/shot_source.hpp"
#include "player/playback/watchdog.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/shot_request.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// What became of a source, told once each.
struct SourceEvent {
    SourceId source = 0;
    std::optional<std::string> failure;  // in plain words; none: it is ready
    std::string unstored;  // the file of the media folder that it is read from; empty: the store
};

/// How many films show less than all of their pictures.
struct FilmsByDetail {
    int all = 0;
    int fewer = 0;
    int still = 0;
};

/// How one source stands, for who asks.
struct SourceState {
    std::string path;
    bool is_film = false;
    Detail detail = Detail::all;  // of a film
    bool is_stored = false;       // played from the store
    bool is_ready = false;
    std::uint64_t late = 0;  // pictures that were due and not there
};

/// The sources of what is on the wall and of what comes next. Reading and ending happen in the background, a
/// few at a time; one that hangs, of a share that has gone, does not keep the others waiting for good.
class SourcePool {
  public:
    explicit SourcePool(MediaPlaces places, SourceOptions options = {})
        : places_(std::move(places)), options_(std::move(options)) {}

    /// What the pictures of sources to come shall be: known once there is a renderer.
    void set_form(PictureForm form) { options_.film.form = form; }

    /// Hardware decoders for sources to come.
    void set_decoders(DecoderMap decoders) { options_.film.decoders = std::move(decoders); }

    /// Called with the path of each file, below the media folder, before anything of it is read.
    void before_opening(std::function<void(const std::string& path)> call) {
        before_opening_ = std::move(call);
    }

    /// The files that are being read or played.
    std::set<std::string> open_files() const {
        std::set<std::string> paths;
        for (const auto& [id, playing] : playing_)
            paths.insert(playing.request.path);
        return paths;
    }

    const DecoderMap& decoders() const { return options_.film.decoders; }

    /// A new source, or another size for one there is. A film that plays from the media folder and is in the
    /// store by now goes over to the clip at the end of a loop.
    void request(const ShotRequest& request);

    /// The source is not needed any more; ends in the background.
    void retire(SourceId source);

    /// All there are; which they were.
    std::vector<SourceId> retire_all();

    /// To be called once a frame: starts what waits, buries what has ended. Photos of another size than asked
    /// for since are read anew once nothing waits, one after the other.
    std::vector<SourceEvent> update();

    /// Takes every source of the frame to its item's time, and each item's slide to the very picture. Where
    /// the sources keep time, once a second the films are judged that cost more than the machine has
    /// (governor.hpp), and a film without a picture for two seconds is built anew (watchdog.hpp).
    void advance(Frame& frame);

    /// The picture of a source as of the last advance(); nothing before its first.
    std::optional<Sample> sample(SourceId source) const;

    /// Waits until advance() of this frame will be exact: for rendering at its own pace.
    /// False: not within `patience`.
    bool wait_for(const Frame& frame, std::chrono::nanoseconds patience);

    /// Waits until every source that was requested is ready or has failed, telling of each.
    std::vector<SourceEvent> wait_until_ready(std::chrono::nanoseconds patience);

    /// Pictures that were due and not there, of all sources so far.
    std::uint64_t late() const;

    FilmsByDetail films() const;

    /// Of each source that plays or gets ready.
    std::vector<SourceState> states() const;

    /// How many are asked for and have no picture yet.
    std::size_t queue() const;

    /// Films that stood still and were built anew, so far.
    std::uint64_t rebuilds() const { return rebuilds_; }

  private:
    struct Playing {
        std::unique_ptr<ShotSource> source;
        ShotRequest request;                // as it was made last
        bool is_stored = false;             // read from the store
        std::unique_ptr<ShotSource> clip;   // takes over from `source` at the seam
        std::chrono::nanoseconds seam{0};   // since the shot began to be shown
        std::chrono::nanoseconds local{0};  // as of the last frame that it was in
        int tries = 0;                      // left, to go over to the clip
        std::optional<Sample> sample;
        std::chrono::nanoseconds seen{-1};  // time of the last frame that it was in
        double salience = 0;                // its share of the screen then
        Vec2 slide;                         // source px
        Watchdog watchdog;
        bool is_software = false;             // without a hardware decoder
        std::optional<std::string> given_up;  // why
        std::uint64_t due = 0;                // as of the governor's last judgement
        std::uint64_t late = 0;               // likewise
        std::chrono::nanoseconds spent{0};    // likewise
        std::chrono::steady_clock::time_point opened;
        bool is_told_ready = false;
        bool is_told_failed = false;

        bool is_preparing() const { return !is_told_ready && !is_told_failed; }
    };

    void start_waiting(std::vector<SourceEvent>& events);
    bool is_stuck(const Playing& playing) const;
    long count_preparing() const;
    bool may_start() const;
    void read_one_anew();
    void prepare_clip();
    void go_over(Playing& playing);
    void start(Playing& playing, bool may_be_stored, std::chrono::nanoseconds at = {});
    void watch(Playing& playing, const DrawItem& item, std::chrono::nanoseconds now);
    void rebuild(Playing& playing, std::chrono::nanoseconds local);
    void govern(std::chrono::nanoseconds now);
    FilmLoad load(SourceId id, Playing& playing, std::chrono::nanoseconds passed);
    void tell(SourceId id, Playing& playing, std::vector<SourceEvent>& events);

    MediaPlaces places_;
    SourceOptions options_;
    std::function<void(const std::string& path)> before_opening_;
    Governor governor_;
    std::chrono::nanoseconds judged_{0};  // when the governor was asked last
    std::deque<ShotRequest> waiting_;
    std::map<SourceId, Playing> playing_;
    std::vector<std::unique_ptr<ShotSource>> ending_;
    std::uint64_t late_of_retired_ = 0;
    std::uint64_t rebuilds_ = 0;
};

}  // namespace vitrine::player
