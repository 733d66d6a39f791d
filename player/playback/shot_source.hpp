#pragma once

#include "player/playback/film_feed.hpp"
#include "player/playback/photo_load.hpp"
#include "player/playback/sample_queue.hpp"
#include "player/scene/shot_request.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace vitrine::player {

/// How sources play.
struct SourceOptions {
    Colour background;  // what shows through where a photo is transparent
    FilmOptions film;
    FilmFactory make_film;    // empty: FilmLoop
    bool keeps_time = false;  // a film too slow for the machine skips pictures; else it falls behind
    std::chrono::nanoseconds opening_patience =
        std::chrono::seconds(15);  // of others with a source that opens
};

/// Plays one shot of a film in a loop, or holds a photo. Decodes in threads of its own, ahead of what is
/// asked for by a few pictures; a file deleted meanwhile plays on. Never throws for a bad file: failure()
/// tells.
class ShotSource {
  public:
    /// Begins at once to read.
    /// @param at  how long the shot has been shown already, by a source before this
    ShotSource(std::string file, const ShotRequest& request, const SourceOptions& options = {},
               std::chrono::nanoseconds at = {});

    /// Whether there is a first picture.
    bool is_ready() const { return current_ || !queue_.is_empty(); }

    /// Why no picture comes any more, in plain words; the last one stays.
    std::optional<std::string> failure() const;

    /// The newest picture due, without waiting; nothing before the first is ready.
    ///
    /// @param local  since the shot began to be shown, never going back; it plays in loops of its duration.
    /// Where decoding cannot keep up pictures are skipped, or the shot falls behind `local`, as the options
    /// say.
    std::optional<Sample> frame_at(std::chrono::nanoseconds local);

    /// Waits until frame_at(local) is exact: for rendering at its own pace. False: not within `patience`.
    bool wait_for(std::chrono::nanoseconds local, std::chrono::nanoseconds patience);

    /// Waits until is_ready() or failure(), but not beyond `patience`.
    void wait_until_ready(std::chrono::nanoseconds patience) const { queue_.wait(patience); }

    /// How far the subject has moved in the picture last given by frame_at(), source px.
    Vec2 slide() const;

    /// Pictures to come get another size; a photo once it is read anew.
    void resize(int width, int height);

    /// Whether the photo has another size than was asked for since it was read.
    bool is_outdated() const {
        return photo_ && photo_->has_ended() && !queue_.is_closed() &&
               (request_.width != read_width_ || request_.height != read_height_);
    }

    /// Reads the photo in the size last asked for; the one there is stays meanwhile. @pre is_outdated()
    void read_anew();

    /// How often a picture was asked for that was not the last one, and how often it was due and not there.
    std::uint64_t due() const { return due_; }

    std::uint64_t late() const { return late_; }

    /// Whether the film has given nothing though it could: no picture was new at the last time, and the next
    /// is not there. One that is merely late, on a busy machine, gives some now and then.
    bool is_starved() const {
        return film_ && detail_ != Detail::still && !has_news_ && queue_.is_empty() && !queue_.is_closed();
    }

    /// Processor time that the film has cost so far.
    std::chrono::nanoseconds spent() const { return film_ ? film_->spent() : std::chrono::nanoseconds(0); }

    /// Which of a film's pictures are shown from now on; a photo has but one.
    void set_detail(Detail detail);

    Detail detail() const { return detail_; }

    /// Begins to end; the destructor does not wait for long once has_ended().
    void stop();
    bool has_ended() const;

  private:
    std::chrono::nanoseconds position(const LoopedSample& sample) const;
    void take_due(std::chrono::nanoseconds target);
    void judge_lateness(std::chrono::nanoseconds local);
    void read_photo();

    std::string file_;
    ShotRequest request_;
    SourceOptions options_;
    SampleQueue queue_;
    std::unique_ptr<FilmFeed> film_;    // of a video
    std::unique_ptr<PhotoLoad> photo_;  // of a photo
    int read_width_ = 0;                // px that the photo was last read for
    int read_height_ = 0;
    bool is_photo_coming_ = false;  // read, but not taken yet
    std::optional<LoopedSample> current_;
    bool has_news_ = false;               // the last frame_at() found another picture than the one before
    std::chrono::nanoseconds behind_{0};  // `local`, by decoding too slowly
    std::chrono::nanoseconds judged_;     // when lateness was judged last; before: the begin
    std::chrono::nanoseconds jumped_{0};  // `local` when the film was last sent elsewhere
    Detail detail_ = Detail::all;
    std::uint64_t due_ = 0;
    std::uint64_t late_ = 0;
};

}  // namespace vitrine::player
