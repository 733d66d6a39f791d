#pragma once

#include "player/playback/film_feed.hpp"
#include "player/playback/photo_load.hpp"
#include "player/playback/sample_queue.hpp"
#include "player/playback/shot_clock.hpp"
#include "player/scene/shot_request.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace vitrine::player {

/// The factories for files of the media folder, which strangers have made. Empty: as for all other files.
struct UploadFactories {
    FilmFactory make_film;
    PhotoFactory make_photo;
};

/// The options of a source.
struct SourceOptions {
    Colour background;  // behind the transparent parts of a photo
    FilmOptions film;
    FilmFactory make_film;    // empty: makes a FilmLoop
    PhotoFactory make_photo;  // empty: makes a PhotoLoad
    UploadFactories uploads;  // a PlayingShot takes them for files that are not in the store
    bool keeps_time = false;  // a film that is too slow skips pictures; else it falls behind
    std::chrono::nanoseconds opening_patience = std::chrono::seconds(15);  // then others need not wait for it
};

/// Plays one shot of a film in a loop, or holds a photo. Decodes in threads of its own, a few pictures ahead.
/// Goes on if the file is deleted meanwhile. Throws nothing for a bad file: failure() reports.
class ShotSource {
  public:
    /// Starts to read at once.
    /// @param at  the time that the shot was already shown, from an earlier source
    ShotSource(std::string file, const ShotRequest& request, const SourceOptions& options = {},
               std::chrono::nanoseconds at = {});

    /// True once there is a first picture.
    bool is_ready() const { return current_ || !queue_.is_empty(); }

    /// The reason why no more pictures come, in plain words. The last picture stays.
    std::optional<std::string> failure() const;

    /// True: the file made its reader crash.
    bool has_crashed() const { return film_ ? film_->has_crashed() : photo_->has_crashed(); }

    /// The newest picture that is due. None: the first picture is not ready. Does not wait. If decoding
    /// cannot keep up, pictures are skipped or the shot falls behind `local`, as the options say.
    /// @param local  time since the shot was first shown; never goes back, and counts over all loops
    std::optional<Sample> picture_at(std::chrono::nanoseconds local);

    /// Waits until picture_at(local) is exact: for rendering at its own pace. False: not within `patience`.
    bool wait_for(std::chrono::nanoseconds local, std::chrono::nanoseconds patience);

    /// Waits until is_ready() or failure(), at most for `patience`.
    void wait_until_ready(std::chrono::nanoseconds patience) const { queue_.wait(patience); }

    /// Changes the size of the pictures to come. A photo changes when it is read again.
    void resize(int width, int height);

    /// True if another size was asked for since the photo was read.
    bool is_outdated() const {
        return photo_ && photo_->has_ended() && !queue_.is_closed() &&
               (request_.width != photo_width_ || request_.height != photo_height_);
    }

    /// Reads the photo again, in the size last asked for. The present picture stays meanwhile.
    /// @pre the source is a photo, and its last reading has ended
    void read_photo();

    ShotCounts counts() const;

    /// True if the film stands still: the last picture_at() found no new picture, and the next one is
    /// missing. A film that is only late, on a busy machine, gives a picture now and then.
    bool is_starved() const {
        return film_ && detail_ != Detail::still && !has_news_ && queue_.is_empty() && !queue_.is_closed();
    }

    /// Sets the share of a film's pictures that is decoded; a photo has only one picture.
    void set_detail(Detail detail);

    Detail detail() const { return detail_; }

    /// Starts to end. The destructor does not wait for long once has_ended().
    void stop();
    bool has_ended() const;

  private:
    std::chrono::nanoseconds position(const LoopedSample& sample) const;
    Vec2 slide_of(const Sample& sample) const;
    void take_due_pictures(std::chrono::nanoseconds target);
    void judge_lateness(std::chrono::nanoseconds local);

    std::string file_;
    ShotRequest request_;
    SourceOptions options_;
    SampleQueue queue_;
    std::unique_ptr<FilmFeed> film_;    // none: a photo
    std::unique_ptr<PhotoFeed> photo_;  // none: a film
    int photo_width_ = 0;               // px that the photo was last read for
    int photo_height_ = 0;
    bool is_photo_coming_ = false;  // a reading whose picture was not yet taken from the queue
    std::optional<LoopedSample> current_;
    bool has_news_ = false;  // the last picture_at() found a new picture
    ShotClock clock_;
    Detail detail_ = Detail::all;
};

}  // namespace vitrine::player
