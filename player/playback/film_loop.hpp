#pragma once

#include "base/media/decode_chain.hpp"
#include "player/playback/film_feed.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace vitrine::player {

/// Decodes a part of a film over and over into a queue, in threads of its own; failures are told, not thrown.
///
/// The queue hides the seam between two loops: while the pictures in it are shown, the film is taken back to
/// the begin. That is a segment seek where the container can do it, which keeps the decoder running; else a
/// flushing seek, after the last picture has reached the queue. Pictures are named by stream time, as buffer
/// times are shifted by edit lists. Where only some of the pictures are wanted the demuxer and the decoder
/// leave out the others (seek flags; avdec_h264's skip-frame does nothing in GStreamer 1.22).
class FilmLoop final : public FilmFeed {
  public:
    /// @param queue  outlives this; closed when nothing more will come
    FilmLoop(FilmPart part, SampleQueue& queue, const FilmOptions& options = {});
    FilmLoop(const FilmLoop&) = delete;
    FilmLoop& operator=(const FilmLoop&) = delete;
    FilmLoop(FilmLoop&&) = delete;
    FilmLoop& operator=(FilmLoop&&) = delete;

    /// Waits for its threads: not for long after has_ended().
    ~FilmLoop() override;

    void resize(int width, int height) override;
    void play_from(Detail detail, std::chrono::nanoseconds at) override;
    void stop() override;

    std::chrono::nanoseconds spent() const override { return spent_.load(); }

    bool has_ended() const override { return has_ended_; }

    std::optional<std::string> failure() const override;

  private:
    enum class Rewind { segment, flush };

    struct Jump {
        Detail detail = Detail::all;
        std::chrono::nanoseconds at{0};  // in loops
    };

    void run();
    void play();
    bool open();
    bool preroll();
    void enter();
    void rewind();
    void follow_wish();
    void jump(const Jump& jump);
    void land(const Jump& jump);
    bool is_playing() const;
    bool seek(int flags, std::chrono::nanoseconds from);
    void post(const char* name);
    bool ends_a_loop(GstMessage* message) const;
    void note_cost();
    GstPtr<GstMessage> next_message();
    std::optional<std::chrono::nanoseconds> time_in_film(GstSample* sample) const;
    GstFlowReturn put(GstSample* sample) noexcept;
    static GstFlowReturn on_sample(GstAppSink* sink, gpointer self);
    static GstPadProbeReturn on_flush(GstPad* pad, GstPadProbeInfo* info, gpointer self);

    struct Size {
        int width = 0;  // px
        int height = 0;
    };

    FilmPart part_;
    SampleQueue& queue_;  // outlives this
    DecoderMap decoders_;
    std::atomic<Size> size_;
    Rewind way_ = Rewind::segment;
    Detail detail_ = Detail::all;
    std::uint64_t pictures_at_rewind_ = 0;
    int barren_loops_ = 0;      // one after the other
    std::uint32_t sought_ = 0;  // GStreamer's number of the last seek
    // Set before the pictures flow, then read by the streaming thread.
    std::chrono::nanoseconds period_{0};  // of a picture
    std::chrono::nanoseconds from_{0};    // where the film is searched to
    std::optional<std::chrono::nanoseconds> to_;
    bool is_named_by_stamp_ = false;  // pictures are, not by stream time
    // Of the streaming thread, and of who seeks while that stands still.
    PictureScaler scaler_;
    std::optional<Jump> landing_;  // with the next flush
    std::thread::id noted_thread_;
    std::chrono::nanoseconds noted_{0};  // processor time of that thread
    std::optional<std::chrono::nanoseconds> last_;
    std::uint64_t loop_ = 0;

    std::atomic<std::uint64_t> pictures_ = 0;  // put so far
    std::atomic<std::chrono::nanoseconds> spent_{std::chrono::nanoseconds(0)};
    std::atomic<bool> has_ended_ = false;
    mutable std::mutex mutex_;
    std::unique_ptr<DecodeChain> chain_;  // guarded by mutex_ until play() has it, ended by run() alone
    bool is_stopped_ = false;             // guarded by mutex_
    std::optional<Jump> wanted_;          // guarded by mutex_
    std::optional<std::string> failure_;  // guarded by mutex_
    std::thread thread_;                  // last: all else is there when it starts
};

}  // namespace vitrine::player
