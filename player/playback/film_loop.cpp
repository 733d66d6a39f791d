#include "player/playback/film_loop.hpp"

#include "base/media/media_type.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace vitrine::player {

namespace {

constexpr const char* tail_words =
    "videoconvertscale ! videoflip video-direction=auto"
    " ! capsfilter caps=\"video/x-raw,format={}\""
    " ! appsink name=pictures sync=false max-buffers=1 enable-last-sample=false";
constexpr std::chrono::nanoseconds usual_period = std::chrono::milliseconds(33);  // if the film does not say
constexpr std::chrono::nanoseconds rounding = std::chrono::milliseconds(1);  // Matroska rounds times to this
constexpr int max_barren_loops = 4;
constexpr const char* jump_word = "vitrine-jump";

std::chrono::nanoseconds period(GstElement* tail) {
    const GstPtr<GstElement> sink = element_named(tail, "pictures");
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

}  // namespace

FilmLoop::FilmLoop(FilmPart part, SampleQueue& queue, const FilmOptions& options)
    : part_(std::move(part)),
      queue_(queue),
      decoders_(options.decoders),
      stream_(part_, queue, options.form),
      thread_([this] { run(); }) {}

FilmLoop::~FilmLoop() {
    stop();
    thread_.join();
}

void FilmLoop::play_from(Detail detail, std::chrono::nanoseconds at) {
    wanted_.put({detail, at});
    control_.post(jump_word);
}

void FilmLoop::stop() {
    queue_.close();
    control_.stop();
}

std::optional<std::string> FilmLoop::failure() const {
    const std::optional<PlaybackFailure> failure = control_.failure();
    return failure ? std::optional(failure->text) : std::nullopt;
}

void FilmLoop::run() {
    try {
        play();
    } catch (const std::exception& error) {
        control_.set_failure({.text = error.what()});
    }
    queue_.close();  // releases a streaming thread that waits in put()
    control_.detach();
    chain_.reset();
    control_.set_ended();
}

void FilmLoop::play() {
    if (!open() || !preroll()) return;
    enter();
    follow_wish();
    while (const GstPtr<GstMessage> message = next_message()) {
        if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_APPLICATION) follow_wish();
        if (seeker_.ends_a_loop(message.get())) rewind();
    }
}

void FilmLoop::follow_wish() {
    if (const std::optional<Jump> wanted = wanted_.take()) jump(*wanted);
}

/// False: stopped meanwhile.
bool FilmLoop::open() {
    start_gstreamer();
    GstPtr<GstElement> tail = make_bin(fmt::format(tail_words, PictureScaler::formats).c_str());
    stream_.connect(element_named(tail.get(), "pictures").get());
    chain_ = std::make_unique<DecodeChain>(part_.file, std::move(tail), DecodeOptions{.instead = decoders_});
    seeker_.set_pipeline(chain_->pipeline(), has_segment_seeks(chain_->format()));
    return control_.attach(chain_->bus());
}

/// False: stopped meanwhile.
bool FilmLoop::preroll() {
    gst_element_set_state(chain_->pipeline(), GST_STATE_PAUSED);  // a failure comes as a message
    while (const GstPtr<GstMessage> message = next_message()) {
        const GstMessageType type = GST_MESSAGE_TYPE(message.get());
        if (type == GST_MESSAGE_ASYNC_DONE) return true;
        if (type == GST_MESSAGE_EOS) throw MediaError(MediaState::failed, "the film has no picture");
    }
    return false;
}

/// Seeks to the first picture of the part. The window starts a third of a picture later than the part: times
/// may be rounded up to milliseconds, and the last picture of the shot before would be shown. It ends half a
/// picture before the part.
void FilmLoop::enter() {
    const MediaFormat format = chain_->format();
    FilmWindow window{.period = period(chain_->tail()), .is_named_by_stamp = has_true_time_stamps(format)};
    window.begin = part_.begin.count() > 0 ? part_.begin + window.period / 3 : part_.begin;
    const std::chrono::nanoseconds whole = chain_->duration();
    if (!starts_at_zero(format) || whole.count() <= 0 || part_.end + rounding < whole)
        window.end = std::max(window.begin + rounding, part_.end - window.period / 2);
    stream_.set_window(window);
    seeker_.set_end(window.end);
    stream_.land_at(part_.at);
    land(part_.at);
    gst_element_set_state(chain_->pipeline(), GST_STATE_PLAYING);  // a failure comes as a message
}

/// Continues from another place, with another detail. For Detail::still nothing is done: nobody takes the
/// pictures.
void FilmLoop::jump(const Jump& jump) {
    detail_ = jump.detail;
    barren_loops_ = 0;
    if (detail_ == Detail::still) return;
    seeker_.set_flags(seek_flags(detail_));
    stream_.land_at(jump.at);
    queue_.refuse(true);  // a streaming thread that waits in put() would block the seek
    land(jump.at);
    queue_.refuse(false);
}

void FilmLoop::land(std::chrono::nanoseconds at) {
    const FilmWindow& window = stream_.window();
    const std::chrono::nanoseconds place =
        at.count() > 0 ? std::max(window.begin, part_.begin + at % part_.duration() + window.period / 3)
                       : window.begin;
    if (!seeker_.jump(place))
        throw MediaError(MediaState::failed, "the film cannot be played from a given time");
}

void FilmLoop::rewind() {
    const bool is_barren = stream_.pictures() == pictures_at_rewind_;
    barren_loops_ = is_barren ? barren_loops_ + 1 : 0;
    pictures_at_rewind_ = stream_.pictures();
    if (barren_loops_ >= max_barren_loops) {
        if (detail_ != Detail::all) return;  // no wanted picture is in the part: the film stands still
        throw MediaError(MediaState::failed, "this part of the film has no picture");
    }
    if (barren_loops_ > 1) seeker_.forbid_segments();
    const std::chrono::nanoseconds begin = stream_.window().begin;
    // Without a picture since the last seek the pipeline may not play yet, and rewind() would wait for it.
    if (!is_barren && seeker_.rewind(begin)) return;
    seeker_.forbid_segments();
    if (!seeker_.jump(begin))
        throw MediaError(MediaState::failed, "the film cannot be played again from its start");
}

/// The next message of the pipeline. None: stopped. @throws MediaError if the message is an error
GstPtr<GstMessage> FilmLoop::next_message() {
    GstPtr<GstMessage> message = control_.next_message();
    if (message && GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_ERROR) throw media_error(message.get());
    return message;
}

}  // namespace vitrine::player
