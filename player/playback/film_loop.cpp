#include "player/playback/film_loop.hpp"

#include "player/playback/container_ways.hpp"
#include "player/playback/shared_frame.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace vitrine::player {

namespace {

constexpr const char* tail_words =
    "videoconvertscale ! videoflip video-direction=auto"
    " ! capsfilter caps=\"video/x-raw,format={}\""
    " ! appsink name=pictures sync=false max-buffers=1 enable-last-sample=false";
constexpr std::chrono::nanoseconds usual_period =
    std::chrono::milliseconds(33);                                           // where the film does not say
constexpr std::chrono::nanoseconds rounding = std::chrono::milliseconds(1);  // of times in Matroska
constexpr GstClockTime state_patience = 5 * GST_SECOND;
constexpr int most_barren_loops = 4;
constexpr const char* stop_name = "vitrine-stop";
constexpr const char* jump_name = "vitrine-jump";

GstPtr<GstElement> named(GstElement* bin, const char* name) {
    return GstPtr<GstElement>(gst_bin_get_by_name(GST_BIN(bin), name));
}

std::chrono::nanoseconds period(GstElement* tail) {
    const GstPtr<GstElement> sink = named(tail, "pictures");
    const GstPtr<GstPad> pad(gst_element_get_static_pad(sink.get(), "sink"));
    const GstPtr<GstCaps> caps(gst_pad_get_current_caps(pad.get()));
    int numerator = 0;
    int denominator = 1;
    if (!caps || !gst_structure_get_fraction(gst_caps_get_structure(caps.get(), 0), "framerate", &numerator,
                                             &denominator)) {
        return usual_period;
    }
    if (numerator <= 0 || denominator <= 0) return usual_period;
    return std::chrono::nanoseconds(1'000'000'000LL * denominator / numerator);
}

int seek_flags(Detail detail) {
    switch (detail) {
    case Detail::references:
        return GST_SEEK_FLAG_TRICKMODE;
    case Detail::keys:
        return GST_SEEK_FLAG_TRICKMODE | GST_SEEK_FLAG_TRICKMODE_KEY_UNITS;
    case Detail::all:
    case Detail::still:
        break;
    }
    return 0;
}

/// Processor time of the thread that asks.
std::chrono::nanoseconds thread_time() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

FilmLoop::FilmLoop(FilmPart part, SampleQueue& queue, const FilmOptions& options)
    : part_(std::move(part)),
      queue_(queue),
      decoders_(options.decoders),
      size_(Size{part_.width, part_.height}),
      scaler_(options.form),
      thread_([this] { run(); }) {}

FilmLoop::~FilmLoop() {
    stop();
    thread_.join();
}

void FilmLoop::resize(int width, int height) {
    size_ = Size{width, height};
}

void FilmLoop::play_from(Detail detail, std::chrono::nanoseconds at) {
    const std::lock_guard lock(mutex_);
    wanted_ = Jump{detail, at};
    if (!is_stopped_) post(jump_name);
}

void FilmLoop::stop() {
    queue_.close();
    const std::lock_guard lock(mutex_);
    if (!std::exchange(is_stopped_, true)) post(stop_name);
}

/// To who waits for messages. @pre the lock is held
void FilmLoop::post(const char* name) {
    if (!chain_) return;
    GstStructure* word = gst_structure_new_empty(name);
    gst_bus_post(chain_->bus(), gst_message_new_application(nullptr, word));  // takes both
}

std::optional<std::string> FilmLoop::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

void FilmLoop::run() {
    try {
        play();
    } catch (const std::exception& error) {
        const std::lock_guard lock(mutex_);
        failure_ = error.what();
    }
    queue_.close();  // lets go of a streaming thread that waits to put
    std::unique_ptr<DecodeChain> ending;
    {
        const std::lock_guard lock(mutex_);
        ending = std::move(chain_);
    }
    ending.reset();
    has_ended_ = true;
}

void FilmLoop::play() {
    if (!open() || !preroll()) return;
    enter();
    follow_wish();
    while (const GstPtr<GstMessage> message = next_message()) {
        if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_APPLICATION) follow_wish();
        if (ends_a_loop(message.get())) rewind();
    }
}

/// A demuxer may have come to the end just before it was sent elsewhere.
bool FilmLoop::ends_a_loop(GstMessage* message) const {
    const GstMessageType type = GST_MESSAGE_TYPE(message);
    return type == GST_MESSAGE_EOS ||
           (type == GST_MESSAGE_SEGMENT_DONE && gst_message_get_seqnum(message) == sought_);
}

void FilmLoop::follow_wish() {
    std::unique_lock lock(mutex_);
    const std::optional<Jump> wanted = std::exchange(wanted_, std::nullopt);
    lock.unlock();
    if (wanted) jump(*wanted);
}

/// False: told to stop meanwhile.
bool FilmLoop::open() {
    start_gstreamer();
    GstPtr<GstElement> tail = make_bin(fmt::format(tail_words, PictureScaler::formats).c_str());
    const GstPtr<GstElement> sink = named(tail.get(), "pictures");
    GstAppSinkCallbacks callbacks{};
    callbacks.new_sample = &FilmLoop::on_sample;
    gst_app_sink_set_callbacks(GST_APP_SINK(sink.get()), &callbacks, this, nullptr);
    const GstPtr<GstPad> pad(gst_element_get_static_pad(sink.get(), "sink"));
    gst_pad_add_probe(pad.get(), GST_PAD_PROBE_TYPE_EVENT_FLUSH, &FilmLoop::on_flush, this, nullptr);
    let_planes_lie(pad.get());
    auto chain =
        std::make_unique<DecodeChain>(part_.file, std::move(tail), DecodeOptions{.instead = decoders_});
    is_named_by_stamp_ = has_true_time_stamps(chain->format());
    way_ = has_segment_seeks(chain->format()) ? Rewind::segment : Rewind::flush;
    const std::lock_guard lock(mutex_);
    if (is_stopped_) return false;
    chain_ = std::move(chain);
    return true;
}

/// False: told to stop meanwhile.
bool FilmLoop::preroll() {
    gst_element_set_state(chain_->pipeline(), GST_STATE_PAUSED);  // a failure comes as a message
    while (const GstPtr<GstMessage> message = next_message()) {
        const GstMessageType type = GST_MESSAGE_TYPE(message.get());
        if (type == GST_MESSAGE_ASYNC_DONE) return true;
        if (type == GST_MESSAGE_EOS) throw MediaError(MediaState::failed, "the film holds no picture");
    }
    return false;
}

/// To the first picture of the part. A third of a picture later than its begin, as times rounded up to
/// milliseconds would else show the last picture of the shot before; and half a picture before the end.
void FilmLoop::enter() {
    period_ = period(chain_->tail());
    from_ = part_.begin.count() > 0 ? part_.begin + period_ / 3 : part_.begin;
    if (chain_->format() == MediaFormat::mpeg_ps)
        from_ = {};  // no picture comes after a search into its midst
    const std::chrono::nanoseconds whole = chain_->duration();
    if (!starts_at_zero(chain_->format()) || whole.count() <= 0 || part_.end + rounding < whole)
        to_ = std::max(from_ + rounding, part_.end - period_ / 2);
    const Jump first{.at = part_.at};
    landing_ = first;
    land(first);
    gst_element_set_state(chain_->pipeline(), GST_STATE_PLAYING);  // a failure comes as a message
}

/// Goes on elsewhere, with another detail. A still film is one whose pictures nobody takes.
void FilmLoop::jump(const Jump& jump) {
    detail_ = jump.detail;
    barren_loops_ = 0;
    if (detail_ == Detail::still) return;
    landing_ = jump;
    queue_.refuse(true);  // a streaming thread that waits to put would keep the seek waiting
    land(jump);
    queue_.refuse(false);
}

void FilmLoop::land(const Jump& jump) {
    const std::chrono::nanoseconds from =
        jump.at.count() > 0 ? std::max(from_, part_.begin + jump.at % part_.duration() + period_ / 3) : from_;
    if (way_ == Rewind::segment && !seek(GST_SEEK_FLAG_FLUSH | GST_SEEK_FLAG_SEGMENT, from))
        way_ = Rewind::flush;
    if (way_ == Rewind::flush && !seek(GST_SEEK_FLAG_FLUSH, from)) {
        throw MediaError(MediaState::failed, "the film cannot be searched");
    }
}

/// The streaming thread stands still and what it had is gone: what comes now is of the place jumped to.
GstPadProbeReturn FilmLoop::on_flush(GstPad*, GstPadProbeInfo* info, gpointer self) {
    if (GST_EVENT_TYPE(gst_pad_probe_info_get_event(info)) != GST_EVENT_FLUSH_STOP) return GST_PAD_PROBE_OK;
    auto* const loop = static_cast<FilmLoop*>(self);
    const std::optional<Jump> landing = std::exchange(loop->landing_, std::nullopt);
    if (!landing) return GST_PAD_PROBE_OK;
    const std::chrono::nanoseconds duration = loop->part_.duration();
    loop->loop_ = static_cast<std::uint64_t>(landing->at / duration);
    loop->last_ = loop->part_.begin + landing->at % duration - loop->period_;
    loop->queue_.refuse(false);
    return GST_PAD_PROBE_OK;
}

void FilmLoop::rewind() {
    const bool is_barren = pictures_ == pictures_at_rewind_;
    barren_loops_ = is_barren ? barren_loops_ + 1 : 0;
    pictures_at_rewind_ = pictures_;
    if (barren_loops_ >= most_barren_loops) {
        if (detail_ != Detail::all) return;  // there is none of those wanted: it stands still
        throw MediaError(MediaState::failed, "the film gives no picture of this part");
    }
    if (barren_loops_ > 1) way_ = Rewind::flush;
    // Without a picture since it was sent there it does not play yet, and that must not be waited for.
    if (way_ == Rewind::segment && !is_barren && is_playing() && seek(GST_SEEK_FLAG_SEGMENT, from_)) return;
    way_ = Rewind::flush;
    if (!seek(GST_SEEK_FLAG_FLUSH, from_)) throw MediaError(MediaState::failed, "the film cannot be rewound");
}

/// Waits for what was asked for: a seek that does not flush would stop for ever in the midst of it, as in a
/// film so short that its end comes first.
bool FilmLoop::is_playing() const {
    GstState state = GST_STATE_NULL;
    return gst_element_get_state(chain_->pipeline(), &state, nullptr, state_patience) ==
               GST_STATE_CHANGE_SUCCESS &&
           state == GST_STATE_PLAYING;
}

bool FilmLoop::seek(int flags, std::chrono::nanoseconds from) {
    flags |= GST_SEEK_FLAG_ACCURATE | seek_flags(detail_);
    const auto to = to_.value_or(std::chrono::nanoseconds(-1));
    GstEvent* event =
        gst_event_new_seek(1.0, GST_FORMAT_TIME, static_cast<GstSeekFlags>(flags), GST_SEEK_TYPE_SET,
                           from.count(), to_ ? GST_SEEK_TYPE_SET : GST_SEEK_TYPE_NONE, to.count());
    sought_ = gst_event_get_seqnum(event);
    return gst_element_send_event(chain_->pipeline(), event) != FALSE;  // which takes it
}

/// The next of the pipeline; none: told to stop. @throws MediaError where it is a failure
GstPtr<GstMessage> FilmLoop::next_message() {
    constexpr auto types =
        static_cast<GstMessageType>(GST_MESSAGE_ERROR | GST_MESSAGE_EOS | GST_MESSAGE_SEGMENT_DONE |
                                    GST_MESSAGE_ASYNC_DONE | GST_MESSAGE_APPLICATION);
    GstPtr<GstMessage> message(gst_bus_timed_pop_filtered(chain_->bus(), GST_CLOCK_TIME_NONE, types));
    if (!message) return nullptr;
    if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_ERROR) throw media_error(message.get());
    if (gst_message_has_name(message.get(), stop_name)) return nullptr;
    return message;
}

GstFlowReturn FilmLoop::on_sample(GstAppSink* sink, gpointer self) {
    const GstPtr<GstSample> sample(gst_app_sink_pull_sample(sink));
    if (!sample) return GST_FLOW_EOS;
    return static_cast<FilmLoop*>(self)->put(sample.get());
}

std::optional<std::chrono::nanoseconds> FilmLoop::time_in_film(GstSample* sample) const {
    const std::uint64_t time = GST_BUFFER_PTS(gst_sample_get_buffer(sample));
    if (is_named_by_stamp_ && GST_CLOCK_TIME_IS_VALID(time)) return std::chrono::nanoseconds(time);
    const std::uint64_t stream_time =
        gst_segment_to_stream_time(gst_sample_get_segment(sample), GST_FORMAT_TIME, time);
    if (!GST_CLOCK_TIME_IS_VALID(stream_time)) return std::nullopt;
    return std::chrono::nanoseconds(stream_time);
}

/// Another thread may stream after a seek.
void FilmLoop::note_cost() {
    const std::chrono::nanoseconds now = thread_time();
    if (noted_thread_ == std::this_thread::get_id()) spent_ = spent_.load() + now - noted_;
    noted_thread_ = std::this_thread::get_id();
    noted_ = now;
}

GstFlowReturn FilmLoop::put(GstSample* sample) noexcept {
    const std::optional<std::chrono::nanoseconds> time = time_in_film(sample);
    if (!time) return GST_FLOW_OK;  // outside the segment
    std::chrono::nanoseconds stream_time = *time;
    if (stream_time < part_.begin - period_ / 2 || (to_ && stream_time >= *to_)) return GST_FLOW_OK;
    if (stream_time <= from_ + rounding) stream_time = part_.begin;  // cut off at the segment's start
    const Size size = size_;
    std::optional<Sample> picture = scaler_.scaled(sample, size.width, size.height, stream_time);
    if (!picture) return GST_FLOW_OK;
    if (last_ && stream_time <= *last_) ++loop_;
    last_ = stream_time;
    note_cost();
    const bool is_open = queue_.put({.sample = std::move(*picture), .loop = loop_, .duration = period_});
    ++pictures_;
    return is_open ? GST_FLOW_OK : GST_FLOW_EOS;
}

}  // namespace vitrine::player
