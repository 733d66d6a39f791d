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

/// The options of a source.
struct SourceOptions {
    Colour background;  // shows through where a photo is transparent
    FilmOptions film;
    FilmFactory make_film;    // empty: FilmLoop
    bool keeps_time = false;  // a film too slow for the machine skips pictures; else it falls behind
    std::chrono::nanoseconds opening_patience = std::chrono::seconds(15);  // then others need not wait for it
};

/// Plays one shot of a film in a loop, or holds a photo. Decodes in threads of its own, a few pictures ahead.
/// A file that is deleted meanwhile plays on. Never throws for a bad file: failure() tells.
class ShotSource {
  public:
    /// Begins to read at once.
    /// @param at  the time that the shot has been shown already, by the source before this one
    ShotSource(std::string file, const ShotRequest& request, const SourceOptions& options = {},
               std::chrono::nanoseconds at = {});

    /// True once there is a first picture.
    bool is_ready() const { return current_ || !queue_.is_empty(); }

    /// The reason why no picture comes any more, in plain words; the last picture stays.
    std::optional<std::string> failure() const;

    /// The newest picture that is due, without waiting; nothing before the first one is ready. Where decoding
    /// cannot keep up, pictures are skipped or the shot falls behind `local`, as the options say.
    /// @param local  time since the shot began to be shown, never going back; it plays in loops of its
    /// duration
    std::optional<Sample> picture_at(std::chrono::nanoseconds local);

    /// Waits until picture_at(local) is exact: for rendering at its own pace. False: not within `patience`.
    bool wait_for(std::chrono::nanoseconds local, std::chrono::nanoseconds patience);

    /// Waits until is_ready() or failure(), but not beyond `patience`.
    void wait_until_ready(std::chrono::nanoseconds patience) const { queue_.wait(patience); }

    /// The way that the subject has moved in the picture that picture_at() gave last, source px.
    Vec2 slide() const;

    /// Pictures to come get another size; a photo gets it when it is read anew.
    void resize(int width, int height);

    /// True if another size was asked for since the photo was read.
    bool is_outdated() const {
        return photo_ && photo_->has_ended() && !queue_.is_closed() &&
               (request_.width != photo_->width() || request_.height != photo_->height());
    }

    /// Reads the photo in the size last asked for; the picture there is stays meanwhile.
    /// @pre the source is of a photo, and the last reading has ended
    void read_photo();

    ShotCounts counts() const;

    /// True if the film has given nothing though it could: no picture was new at the last time, and the next
    /// one is not there. A film that is merely late, on a busy machine, gives some now and then.
    bool is_starved() const {
        return film_ && detail_ != Detail::still && !has_news_ && queue_.is_empty() && !queue_.is_closed();
    }

    /// Chooses which of a film's pictures are shown from now on; a photo has but one.
    void set_detail(Detail detail);

    Detail detail() const { return detail_; }

    /// Begins to end; the destructor does not wait for long once has_ended().
    void stop();
    bool has_ended() const;

  private:
    std::chrono::nanoseconds position(const LoopedSample& sample) const;
    void take_due_pictures(std::chrono::nanoseconds target);
    void judge_lateness(std::chrono::nanoseconds local);

    std::string file_;
    ShotRequest request_;
    SourceOptions options_;
    SampleQueue queue_;
    std::unique_ptr<FilmFeed> film_;    // none: a photo
    std::unique_ptr<PhotoLoad> photo_;  // none: a film
    bool is_photo_coming_ = false;      // read, but not taken from the queue yet
    std::optional<LoopedSample> current_;
    bool has_news_ = false;  // the last picture_at() found another picture than the one before
    ShotClock clock_;
    Detail detail_ = Detail::all;
};

}  // namespace vitrine::player
