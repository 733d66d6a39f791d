#pragma once

#include "base/media/gst_ptr.hpp"
#include "player/playback/film_feed.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <thread>

namespace vitrine::player {

/// The streaming side of a FilmLoop: turns decoded pictures into samples and puts them into the queue, each
/// with the number of its loop. GStreamer's streaming thread calls it. The loop's own thread calls
/// set_window() and land_at() only while the streaming thread stands still, and the thread-safe methods at
/// any time.
class FilmStream {
  public:
    /// @param queue  outlives this
    FilmStream(const FilmPart& part, SampleQueue& queue, PictureForm form);

    /// Changes the size of the pictures to come. Thread-safe.
    void resize(int width, int height) { size_ = Size{width, height}; }

    /// Processor time that the pictures so far have cost. Thread-safe.
    std::chrono::nanoseconds spent() const { return spent_.load(); }

    /// The number of pictures put so far. Thread-safe.
    std::uint64_t pictures() const { return pictures_; }

    /// Takes the pictures of an appsink. This outlives the sink's pipeline.
    void connect(GstElement* sink);

    void set_window(const FilmWindow& window) { window_ = window; }

    const FilmWindow& window() const { return window_; }

    /// The next flush moves the film to this place.
    /// @param at  time over all loops, since the start of the first one
    void land_at(std::chrono::nanoseconds at) { landing_ = at; }

  private:
    struct alignas(8) Size {  // both are read and written at once, without a lock
        int width = 0;        // px
        int height = 0;
    };

    static GstFlowReturn on_sample(GstAppSink* sink, gpointer self);
    static GstPadProbeReturn on_flush(GstPad* pad, GstPadProbeInfo* info, gpointer self);
    GstFlowReturn put(GstSample* sample);
    std::optional<std::chrono::nanoseconds> time_in_film(GstSample* sample) const;
    void note_cost();

    FilmPart part_;
    SampleQueue& queue_;  // outlives this
    std::atomic<Size> size_;
    FilmWindow window_;
    PictureScaler scaler_;
    std::optional<std::chrono::nanoseconds> landing_;  // time over all loops after the next flush
    std::optional<std::chrono::nanoseconds> last_;     // stream time of the last picture
    std::uint64_t loop_ = 0;
    std::thread::id noted_thread_;
    std::chrono::nanoseconds noted_{0};  // processor time of noted_thread_
    std::atomic<std::uint64_t> pictures_ = 0;
    std::atomic<std::chrono::nanoseconds> spent_{std::chrono::nanoseconds(0)};
};

}  // namespace vitrine::player
