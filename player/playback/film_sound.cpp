#include "player/playback/film_sound.hpp"

#include "base/media/sound_chain.hpp"
#include "player/playback/container_ways.hpp"
#include "player/playback/sound_fade.hpp"
#include "player/playback/sound_timeline.hpp"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr const char* leave_name = "vitrine-leave";
constexpr const char* stop_name = "vitrine-stop";
constexpr const char* silent_name = "vitrine-silent";
constexpr nanoseconds lead = 150ms;            // until it plays where it was sent
constexpr nanoseconds rounding = 1ms;          // of times in Matroska
constexpr nanoseconds leave_patience = 600ms;  // for a device to take what is faded out
constexpr nanoseconds end_patience = 1s;
constexpr GstClockTime state_patience = 5 * GST_SECOND;
constexpr int most_barren_loops = 4;

GstPtr<GstElement> named(GstElement* bin, const char* name) {
    return GstPtr<GstElement>(gst_bin_get_by_name(GST_BIN(bin), name));
}

nanoseconds monotonic_now() {
    return std::chrono::steady_clock::now().time_since_epoch();
}

}  // namespace

/// All but the thread. The order of its life: open, preroll, a seek to where the picture is, play; at the end
/// of each loop a seek to the begin.
class FilmSound::Work {
  public:
    Work(SoundPart part, SoundSink make_sink) : part_(std::move(part)), make_sink_(std::move(make_sink)) {}

    void run() {
        try {
            play();
        } catch (const std::exception& error) {
            fail({.text = error.what(), .is_of_film = sink_ != nullptr});
        }
        std::unique_ptr<SoundChain> ending;
        {
            const std::lock_guard lock(mutex_);
            ending = std::move(chain_);
        }
        ending.reset();
        const std::lock_guard lock(mutex_);
        has_ended_ = true;
        changed_.notify_all();
    }

    void leave() {
        fade_.leave();
        const std::lock_guard lock(mutex_);
        is_leaving_ = true;
        post(leave_name);
    }

    /// False: it goes on, for something in it does not answer.
    bool stop() {
        std::unique_lock lock(mutex_);
        is_stopped_ = true;
        post(stop_name);
        return changed_.wait_for(lock, end_patience, [this] { return has_ended_; });
    }

    bool has_ended() const {
        const std::lock_guard lock(mutex_);
        return has_ended_;
    }

    bool is_heard() const { return is_heard_; }

    std::optional<Failure> failure() const {
        const std::lock_guard lock(mutex_);
        return failure_;
    }

  private:
    enum class Rewind { segment, flush };

    void play() {
        if (!open() || !preroll()) return;
        land();
        gst_element_set_state(chain_->pipeline(), GST_STATE_PLAYING);  // a failure comes as a message
        while (const GstPtr<GstMessage> message = next_message()) {
            if (gst_message_has_name(message.get(), silent_name)) return;
            if (ends_a_loop(message.get()) && !rewind()) return;
        }
    }

    /// False: told to stop meanwhile.
    bool open() {
        start_gstreamer();
        sink_ = make_sink_();
        GstPtr<GstElement> tail = sound_tail(sink_.get());
        const GstPtr<GstElement> fade = named(tail.get(), "fade");
        const GstPtr<GstPad> pad(gst_element_get_static_pad(fade.get(), "sink"));
        gst_pad_add_probe(pad.get(),
                          static_cast<GstPadProbeType>(GST_PAD_PROBE_TYPE_EVENT_DOWNSTREAM |
                                                       GST_PAD_PROBE_TYPE_EVENT_FLUSH),
                          &Work::on_event, this, nullptr);
        gst_pad_add_probe(pad.get(), GST_PAD_PROBE_TYPE_BUFFER, &Work::on_buffer, this, nullptr);
        auto chain = std::make_unique<SoundChain>(part_.file, std::move(tail), SoundChain::Form::raw);
        is_named_by_stamp_ = has_true_time_stamps(chain->format());
        way_ = has_segment_seeks(chain->format()) ? Rewind::segment : Rewind::flush;
        GstClock* clock = gst_system_clock_obtain();  // the monotonic one
        gst_pipeline_use_clock(GST_PIPELINE(chain->pipeline()), clock);
        gst_object_unref(clock);
        gst_element_set_start_time(chain->pipeline(), GST_CLOCK_TIME_NONE);  // its base time is ours
        gst_element_set_base_time(chain->pipeline(), static_cast<GstClockTime>(part_.origin.count()));
        const std::lock_guard lock(mutex_);
        if (is_stopped_ || is_leaving_) return false;
        chain_ = std::move(chain);
        return true;
    }

    /// False: told to stop meanwhile.
    bool preroll() {
        gst_element_set_state(chain_->pipeline(), GST_STATE_PAUSED);  // a failure comes as a message
        while (const GstPtr<GstMessage> message = next_message()) {
            if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_ASYNC_DONE) return true;
            if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_EOS) return false;  // there is none in it
        }
        return false;
    }

    /// To where the picture will be.
    void land() {
        gint64 whole = -1;
        const bool is_known =
            gst_element_query_duration(chain_->pipeline(), GST_FORMAT_TIME, &whole) != FALSE;
        if (!starts_at_zero(chain_->format()) || !is_known || part_.end + rounding < nanoseconds(whole))
            to_ = part_.end;
        const nanoseconds local = std::max(nanoseconds(0), monotonic_now() - part_.origin) + lead;
        loop_ = local / part_.duration();
        const nanoseconds from = part_.begin + local % part_.duration();
        if (way_ == Rewind::segment && !seek(GST_SEEK_FLAG_FLUSH | GST_SEEK_FLAG_SEGMENT, from))
            way_ = Rewind::flush;
        if (way_ == Rewind::flush && !seek(GST_SEEK_FLAG_FLUSH, from))
            throw std::runtime_error("its sound cannot be searched");
    }

    /// False: there is nothing to be heard in this part.
    bool rewind() {
        barren_loops_ = has_sounded_.exchange(false) ? 0 : barren_loops_ + 1;
        if (barren_loops_ >= most_barren_loops) return false;
        ++loop_;
        if (way_ == Rewind::segment && is_playing() && seek(GST_SEEK_FLAG_SEGMENT, part_.begin)) return true;
        way_ = Rewind::flush;
        land();
        return true;
    }

    /// A demuxer may have come to the end just before it was sent elsewhere.
    bool ends_a_loop(GstMessage* message) const {
        const GstMessageType type = GST_MESSAGE_TYPE(message);
        return type == GST_MESSAGE_EOS ||
               (type == GST_MESSAGE_SEGMENT_DONE && gst_message_get_seqnum(message) == sought_);
    }

    bool is_playing() const {
        GstState state = GST_STATE_NULL;
        return gst_element_get_state(chain_->pipeline(), &state, nullptr, state_patience) ==
                   GST_STATE_CHANGE_SUCCESS &&
               state == GST_STATE_PLAYING;
    }

    bool seek(int flags, nanoseconds from) {
        GstEvent* event = gst_event_new_seek(
            1.0, GST_FORMAT_TIME, static_cast<GstSeekFlags>(flags | GST_SEEK_FLAG_ACCURATE),
            GST_SEEK_TYPE_SET, from.count(), to_ ? GST_SEEK_TYPE_SET : GST_SEEK_TYPE_NONE,
            to_.value_or(nanoseconds(-1)).count());
        sought_ = gst_event_get_seqnum(event);
        timeline_.expect(sought_, loop_);
        return gst_element_send_event(chain_->pipeline(), event) != FALSE;  // which takes it
    }

    /// The next of the pipeline; none: told to stop, or gone for long enough.
    /// @throws std::runtime_error where it is a failure of the film
    GstPtr<GstMessage> next_message() {
        constexpr auto types =
            static_cast<GstMessageType>(GST_MESSAGE_ERROR | GST_MESSAGE_EOS | GST_MESSAGE_SEGMENT_DONE |
                                        GST_MESSAGE_ASYNC_DONE | GST_MESSAGE_APPLICATION);
        while (true) {
            const GstClockTime patience =
                is_going_ ? static_cast<GstClockTime>(leave_patience.count()) : GST_CLOCK_TIME_NONE;
            GstPtr<GstMessage> message(gst_bus_timed_pop_filtered(chain_->bus(), patience, types));
            if (!message || gst_message_has_name(message.get(), stop_name)) return nullptr;
            if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_ERROR) {
                fail({.text = text_of(message.get()), .is_of_film = !is_of_sink(message.get())});
                return nullptr;
            }
            if (!gst_message_has_name(message.get(), leave_name)) return message;
            is_going_ = true;
        }
    }

    bool is_of_sink(GstMessage* message) const {
        GstObject* sink = GST_OBJECT(sink_.get());
        return GST_MESSAGE_SRC(message) == sink || gst_object_has_as_ancestor(GST_MESSAGE_SRC(message), sink);
    }

    void fail(Failure failure) {
        const std::lock_guard lock(mutex_);
        failure_ = std::move(failure);
    }

    /// To who waits for messages. @pre the lock is held
    void post(const char* name) {
        if (!chain_) return;
        GstStructure* word = gst_structure_new_empty(name);
        gst_bus_post(chain_->bus(), gst_message_new_application(nullptr, word));  // takes both
    }

    /// A loop's place in running time is the shot's own time.
    static GstPadProbeReturn on_event(GstPad*, GstPadProbeInfo* info, gpointer self) {
        GstEvent* event = gst_pad_probe_info_get_event(info);
        auto* const work = static_cast<Work*>(self);
        if (GST_EVENT_TYPE(event) == GST_EVENT_FLUSH_STOP) work->fade_.come();
        if (GST_EVENT_TYPE(event) != GST_EVENT_SEGMENT) return GST_PAD_PROBE_OK;
        info->data = work->timeline_.placed(event, work->is_named_by_stamp_).release();
        gst_event_unref(event);
        return GST_PAD_PROBE_OK;
    }

    static GstPadProbeReturn on_buffer(GstPad* pad, GstPadProbeInfo* info, gpointer self) {
        auto* const work = static_cast<Work*>(self);
        const GstPtr<GstCaps> caps(gst_pad_get_current_caps(pad));
        int rate = 0;
        int channels = 0;
        const GstStructure* words = caps ? gst_caps_get_structure(caps.get(), 0) : nullptr;
        if (!words || !gst_structure_get_int(words, "rate", &rate) ||
            !gst_structure_get_int(words, "channels", &channels) || rate <= 0 || channels <= 0)
            return GST_PAD_PROBE_OK;
        info->data = gst_buffer_make_writable(gst_pad_probe_info_get_buffer(info));
        work->fade_.apply(gst_pad_probe_info_get_buffer(info), rate, channels);
        work->has_sounded_ = work->is_heard_ = true;
        if (work->fade_.is_silent() && !std::exchange(work->is_silent_, true)) {
            const std::lock_guard lock(work->mutex_);
            work->post(silent_name);
        }
        return GST_PAD_PROBE_OK;
    }

    SoundPart part_;
    SoundSink make_sink_;
    SoundTimeline timeline_{part_.begin, part_.duration()};
    GstPtr<GstElement> sink_;
    Rewind way_ = Rewind::segment;
    bool is_named_by_stamp_ = false;
    std::optional<nanoseconds> to_;  // stream time; none: to the end of the film
    std::int64_t loop_ = 0;
    std::uint32_t sought_ = 0;
    int barren_loops_ = 0;
    bool is_going_ = false;
    bool is_silent_ = false;  // of the streaming thread
    SoundFade fade_;
    std::atomic<bool> has_sounded_{false};  // in this loop
    std::atomic<bool> is_heard_{false};
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::unique_ptr<SoundChain> chain_;  // guarded by mutex_ against other threads
    std::optional<Failure> failure_;     // guarded by mutex_
    bool is_leaving_ = false;            // guarded by mutex_
    bool is_stopped_ = false;            // guarded by mutex_
    bool has_ended_ = false;             // guarded by mutex_
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
    return work_->has_ended();
}

bool FilmSound::is_heard() const {
    return work_->is_heard();
}

std::optional<FilmSound::Failure> FilmSound::failure() const {
    return work_->failure();
}

}  // namespace vitrine::player
