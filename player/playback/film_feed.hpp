#pragma once

#include "base/media/decode_chain.hpp"
#include "player/playback/picture_scaler.hpp"
#include "player/playback/sample_queue.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace vitrine::player {

/// The share of a film's pictures that is decoded, from all to none.
enum class Detail {
    all,
    references,  // leaves out the pictures that no other picture needs
    keys,        // only the pictures that need no other picture
    still,       // no further picture
};

/// A part of a film that is decoded in a loop.
struct FilmPart {
    std::string file;
    std::chrono::nanoseconds begin{0};  // half-open [begin, end) in stream time
    std::chrono::nanoseconds end{0};
    int width = 0;  // px of the upright pictures asked for
    int height = 0;
    std::chrono::nanoseconds at{0};  // time played already, over all loops: the place to start from

    std::chrono::nanoseconds duration() const { return std::max(end - begin, std::chrono::nanoseconds(1)); }
};

/// The place of a part in its film, in the film's own times. Known once the pipeline has its first picture.
struct FilmWindow {
    std::chrono::nanoseconds period{0};  // time of one picture
    std::chrono::nanoseconds begin{0};   // the time that a seek goes to
    std::optional<std::chrono::nanoseconds> end;
    bool is_named_by_stamp = false;  // a picture's time is its time stamp, not its stream time
};

struct FilmOptions {
    PictureForm form = PictureForm::bgra;
    DecoderMap decoders;  // hardware decoders, by the name of the decoder that each replaces
};

/// Fills a queue with the pictures of a part of a film, in threads of its own. Throws nothing: failure()
/// reports. An interface, so that tests can use a film that stalls.
class FilmFeed {
  public:
    FilmFeed() = default;
    FilmFeed(const FilmFeed&) = delete;
    FilmFeed& operator=(const FilmFeed&) = delete;
    FilmFeed(FilmFeed&&) = delete;
    FilmFeed& operator=(FilmFeed&&) = delete;
    virtual ~FilmFeed() = default;

    /// Changes the size of the pictures decoded from now on.
    virtual void resize(int width, int height) = 0;

    /// Continues from another place, with another share of the pictures.
    /// @param at  time over all loops, since the start of the first one
    virtual void play_from(Detail detail, std::chrono::nanoseconds at) = 0;

    /// Processor time that the pictures so far have cost.
    virtual std::chrono::nanoseconds spent() const = 0;

    /// Asks the feed to end. The destructor does not wait for long once has_ended().
    virtual void stop() = 0;

    virtual bool has_ended() const = 0;

    /// The reason why it ended by itself, in plain words.
    virtual std::optional<std::string> failure() const = 0;

    /// True: what it plays made its reader crash. A feed in this process cannot report that.
    virtual bool has_crashed() const { return false; }
};

/// @param queue  outlives the feed, which closes it when no more pictures will come
using FilmFactory =
    std::function<std::unique_ptr<FilmFeed>(const FilmPart&, SampleQueue& queue, const FilmOptions&)>;

}  // namespace vitrine::player
