#include "player/playback/sound/film_sound.hpp"

#include "base/media/media_type.hpp"
#include "base/media/sound_chain.hpp"
#include "player/playback/loop_seeker.hpp"
#include "player/playback/sound/sound_stream.hpp"

#include <atomic>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr const char* leave_word = "vitrine-leave";
constexpr nanoseconds lead = 150ms;            // the time that a seek takes until the sound plays
constexpr nanoseconds rounding = 1ms;          // Matroska rounds times to this
constexpr nanoseconds leave_patience = 600ms;  // the time in which a device plays the faded rest
constexpr nanoseconds end_patience = 1s;
constexpr int max_barren_loops = 4;

nanoseconds monotonic_now() {
    return std::chrono::steady_clock::now().time_since_epoch();
}

/// Makes the monotonic clock the pipeline's clock. Its running time starts at `origin`.
void set_clock(GstElement* pipeline, nanoseconds origin) {
    GstClock* clock = gst_system_clock_obtain();  // the monotonic one
    gst_pipeline_use_clock(GST_PIPELINE(pipeline), clock);
    gst_object_unref(clock);
    gst_element_set_start_time(pipeline, GST_CLOCK_TIME_NONE);  // we set the base time, not the pipeline
    gst_element_set_base_time(pipeline, static_cast<GstClockTime>(origin.count()));
}

}  // namespace

/// Everything but the thread. Its life: open, preroll, seek to the picture's place, play; at the end of each
/// loop it seeks to the start.
class FilmSound::Work {
  public:
    Work(SoundPart part, SoundSink make_sink)
        : part_(std::move(part)),
          make_sink_(std::move(make_sink)),
          stream_(part_.begin, part_.duration(), control_),
          seeker_([this](std::uint32_t seek) { stream_.expect_loop(seek, loop_); }) {}

    void run() {
        try {
            play();
        } catch (const std::exception& error) {
            control_.set_failure({.text = error.what(), .is_of_film = sink_ != nullptr});
        }
        control_.detach();
        chain_.reset();
        control_.set_ended();
    }

    void leave() {
        stream_.fade_out();
        is_leaving_ = true;
        control_.post(leave_word);
    }

    /// False: the thread still runs, because something in it does not answer.
    bool stop() {
        control_.stop();
        return control_.wait_for_end(end_patience);
    }

    bool is_heard() const { return stream_.is_heard(); }

    const PipelineControl& control() const { return control_; }

  private:
    void play() {
        if (!open() || !preroll()) return;
        land();
        gst_element_set_state(chain_->pipeline(), GST_STATE_PLAYING);  // a failure comes as a message
        while (const GstPtr<GstMessage> message = next_message()) {
            if (gst_message_has_name(message.get(), SoundStream::silent_word)) return;
            if (seeker_.ends_a_loop(message.get()) && !rewind()) return;
        }
    }

    /// False: stopped meanwhile.
    bool open() {
        start_gstreamer();
        sink_ = make_sink_();
        GstPtr<GstElement> tail = sound_tail(sink_.get());
        const GstPtr<GstPad> pad(gst_element_get_static_pad(element_named(tail.get(), "fade").get(), "sink"));
        chain_ = std::make_unique<SoundChain>(part_.file, std::move(tail), SoundChain::Form::raw);
        stream_.connect(pad.get(), has_true_time_stamps(chain_->format()));
        seeker_.set_pipeline(chain_->pipeline(), has_segment_seeks(chain_->format()));
        set_clock(chain_->pipeline(), part_.origin);
        return control_.attach(chain_->bus()) && !is_leaving_;
    }

    /// False: stopped meanwhile, or there is no sound.
    bool preroll() {
        gst_element_set_state(chain_->pipeline(), GST_STATE_PAUSED);  // a failure comes as a message
        while (const GstPtr<GstMessage> message = next_message()) {
            if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_ASYNC_DONE) return true;
            if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_EOS) return false;  // there is no sound
        }
        return false;
    }

    /// Seeks to the place that the picture will have reached.
    void land() {
        gint64 whole = -1;
        const bool is_known =
            gst_element_query_duration(chain_->pipeline(), GST_FORMAT_TIME, &whole) != FALSE;
        if (!starts_at_zero(chain_->format()) || !is_known || part_.end + rounding < nanoseconds(whole))
            seeker_.set_end(part_.end);
        const nanoseconds local = std::max(nanoseconds(0), monotonic_now() - part_.origin) + lead;
        loop_ = local / part_.duration();
        if (!seeker_.jump(part_.begin + local % part_.duration()))
            throw std::runtime_error("its sound cannot be played from a given time");
    }

    /// False: this part has no sound.
    bool rewind() {
        barren_loops_ = stream_.take_sounded() ? 0 : barren_loops_ + 1;
        if (barren_loops_ >= max_barren_loops) return false;
        ++loop_;
        if (!seeker_.rewind(part_.begin)) land();
        return true;
    }

    /// The next message of the pipeline. None: stopped, faded out for long enough, or failed.
    GstPtr<GstMessage> next_message() {
        while (true) {
            GstPtr<GstMessage> message = control_.next_message(
                is_going_ ? static_cast<GstClockTime>(leave_patience.count()) : GST_CLOCK_TIME_NONE);
            if (!message) return nullptr;
            if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_ERROR) {
                control_.set_failure(
                    {.text = text_of(message.get()), .is_of_film = !is_of_sink(message.get())});
                return nullptr;
            }
            if (!gst_message_has_name(message.get(), leave_word)) return message;
            is_going_ = true;
        }
    }

    bool is_of_sink(GstMessage* message) const {
        GstObject* sink = GST_OBJECT(sink_.get());
        return GST_MESSAGE_SRC(message) == sink || gst_object_has_as_ancestor(GST_MESSAGE_SRC(message), sink);
    }

    SoundPart part_;
    SoundSink make_sink_;
    PipelineControl control_;
    std::atomic<bool> is_leaving_{false};
    SoundStream stream_;
    // The members below belong to the sound's own thread.
    GstPtr<GstElement> sink_;
    std::unique_ptr<SoundChain> chain_;
    LoopSeeker seeker_;
    std::int64_t loop_ = 0;
    int barren_loops_ = 0;
    bool is_going_ = false;  // it fades out
};

FilmSound::FilmSound(const SoundPart& part, const SoundSink& make_sink)
    : work_(std::make_shared<Work>(part, make_sink)), thread_([work = work_] { work->run(); }) {}

FilmSound::~FilmSound() {
    if (work_->stop())
        thread_.join();
    else
        thread_.detach();
}

void FilmSound::leave() {
    work_->leave();
}

bool FilmSound::has_ended() const {
    return work_->control().has_ended();
}

bool FilmSound::is_heard() const {
    return work_->is_heard();
}

std::optional<PlaybackFailure> FilmSound::failure() const {
    return work_->control().failure();
}

}  // namespace vitrine::player
