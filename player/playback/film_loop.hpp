#pragma once

#include "base/media/decode_chain.hpp"
#include "base/system/mailbox.hpp"
#include "player/playback/film_feed.hpp"
#include "player/playback/film_stream.hpp"
#include "player/playback/loop_seeker.hpp"
#include "player/playback/pipeline_control.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace vitrine::player {

/// Decodes a part of a film in a loop into a queue, in threads of its own. Throws nothing: failure() reports.
///
/// The queue hides the seam between two loops: while its pictures are shown, the film is taken back to the
/// start of the part. If the container can do it, that is a segment seek, which keeps the decoder running;
/// else a flushing seek, after the last picture has reached the queue. A picture's time is its stream time,
/// because edit lists shift buffer times. If only some of the pictures are wanted, the demuxer and the
/// decoder leave out the others (seek flags; avdec_h264's skip-frame does nothing in GStreamer 1.22).
///
/// Threads: the owner's thread calls the public methods; the loop's own thread runs the pipeline; GStreamer's
/// streaming thread uses `stream_`.
class FilmLoop final : public FilmFeed {
  public:
    /// @param queue  outlives this; closed when no more pictures will come
    FilmLoop(FilmPart part, SampleQueue& queue, const FilmOptions& options = {});
    FilmLoop(const FilmLoop&) = delete;
    FilmLoop& operator=(const FilmLoop&) = delete;
    FilmLoop(FilmLoop&&) = delete;
    FilmLoop& operator=(FilmLoop&&) = delete;

    /// Waits for its threads, but not for long once has_ended().
    ~FilmLoop() override;

    void resize(int width, int height) override { stream_.resize(width, height); }

    void play_from(Detail detail, std::chrono::nanoseconds at) override;
    void stop() override;

    std::chrono::nanoseconds spent() const override { return stream_.spent(); }

    bool has_ended() const override { return control_.has_ended(); }

    std::optional<std::string> failure() const override;

  private:
    struct Jump {
        Detail detail = Detail::all;
        std::chrono::nanoseconds at{0};  // time over all loops
    };

    void run();
    void play();
    bool open();
    bool preroll();
    void enter();
    void rewind();
    void follow_wish();
    void jump(const Jump& jump);
    void land(std::chrono::nanoseconds at);
    GstPtr<GstMessage> next_message();

    FilmPart part_;
    SampleQueue& queue_;  // outlives this
    DecoderMap decoders_;
    Mailbox<Jump> wanted_;  // from the owner's thread
    PipelineControl control_;
    FilmStream stream_;
    // The members below belong to the loop's own thread.
    std::unique_ptr<DecodeChain> chain_;
    LoopSeeker seeker_;
    Detail detail_ = Detail::all;
    std::uint64_t pictures_at_rewind_ = 0;
    int barren_loops_ = 0;  // loops without a picture, one after another
    std::thread thread_;    // last: it uses all members above
};

}  // namespace vitrine::player
