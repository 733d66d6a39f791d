#pragma once

#include "base/media/decode_chain.hpp"
#include "player/playback/picture_scaler.hpp"
#include "player/playback/sample_queue.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace vitrine {

/// A part of a film to be decoded over and over.
struct FilmPart {
    std::string file;
    std::chrono::nanoseconds begin{0};  // half-open [begin, end) in stream time
    std::chrono::nanoseconds end{0};
    int width = 0;  // px of the pictures wanted, upright
    int height = 0;
};

/// Decodes a part of a film over and over into a queue, in threads of its own; failures are told, not thrown.
///
/// The queue hides the seam between two loops: while the pictures in it are shown, the film is taken back to
/// the begin. That is a segment seek where the container can do it, which keeps the decoder running; else a
/// flushing seek, after the last picture has reached the queue. Pictures are named by stream time, as buffer
/// times are shifted by edit lists.
class FilmLoop {
  public:
    /// @param queue  outlives this; closed when nothing more will come
    FilmLoop(FilmPart part, SampleQueue& queue, PictureForm form = PictureForm::rgba);
    FilmLoop(const FilmLoop&) = delete;
    FilmLoop& operator=(const FilmLoop&) = delete;
    FilmLoop(FilmLoop&&) = delete;
    FilmLoop& operator=(FilmLoop&&) = delete;

    /// Waits for its threads: not for long after has_ended().
    ~FilmLoop();

    /// Pictures decoded from now on have another size.
    void resize(int width, int height);

    /// Begins to end it.
    void stop();

    bool has_ended() const { return has_ended_; }

    /// Why it ended by itself, in plain words.
    std::optional<std::string> failure() const;

  private:
    enum class Rewind { segment, flush };

    void run();
    void play();
    bool open();
    bool preroll();
    void enter();
    void rewind();
    bool is_playing() const;
    bool seek(int flags);
    GstPtr<GstMessage> next_message();
    std::optional<std::chrono::nanoseconds> time_in_film(GstSample* sample) const;
    GstFlowReturn put(GstSample* sample) noexcept;
    static GstFlowReturn on_sample(GstAppSink* sink, gpointer self);

    struct Size {
        int width = 0;  // px
        int height = 0;
    };

    FilmPart part_;
    SampleQueue& queue_;  // outlives this
    std::atomic<Size> size_;
    Rewind way_ = Rewind::segment;
    std::uint64_t pictures_at_rewind_ = 0;
    int barren_loops_ = 0;  // one after the other
    // Set before the pictures flow, then read by the streaming thread.
    std::chrono::nanoseconds period_{0};  // of a picture
    std::chrono::nanoseconds from_{0};    // where the film is searched to
    std::optional<std::chrono::nanoseconds> to_;
    bool is_named_by_stamp_ = false;  // pictures are, not by stream time
    // Of the streaming thread.
    PictureScaler scaler_;
    std::optional<std::chrono::nanoseconds> last_;
    std::uint64_t loop_ = 0;

    std::atomic<std::uint64_t> pictures_ = 0;  // put so far
    std::atomic<bool> has_ended_ = false;
    mutable std::mutex mutex_;
    std::unique_ptr<DecodeChain> chain_;  // guarded by mutex_ until play() has it, ended by run() alone
    bool is_stopped_ = false;             // guarded by mutex_
    std::optional<std::string> failure_;  // guarded by mutex_
    std::thread thread_;                  // last: all else is there when it starts
};

}  // namespace vitrine
