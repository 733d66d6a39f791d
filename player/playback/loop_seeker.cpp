#include "player/playback/loop_seeker.hpp"

namespace vitrine::player {

namespace {

constexpr GstClockTime state_patience = 5 * GST_SECOND;

}  // namespace

void LoopSeeker::set_pipeline(GstElement* pipeline, bool has_segments) {
    pipeline_ = pipeline;
    has_segments_ = has_segments;
}

bool LoopSeeker::jump(std::chrono::nanoseconds place) {
    if (has_segments_ && seek(GST_SEEK_FLAG_FLUSH | GST_SEEK_FLAG_SEGMENT, place)) return true;
    has_segments_ = false;
    return seek(GST_SEEK_FLAG_FLUSH, place);
}

bool LoopSeeker::rewind(std::chrono::nanoseconds place) {
    if (has_segments_ && is_playing() && seek(GST_SEEK_FLAG_SEGMENT, place)) return true;
    has_segments_ = false;
    return false;
}

bool LoopSeeker::ends_a_loop(GstMessage* message) const {
    const GstMessageType type = GST_MESSAGE_TYPE(message);
    return type == GST_MESSAGE_EOS ||
           (type == GST_MESSAGE_SEGMENT_DONE && gst_message_get_seqnum(message) == seek_);
}

/// Waits until the pipeline plays. A seek that does not flush stops it for ever if it does not play yet, as
/// in a film so short that its end comes first.
bool LoopSeeker::is_playing() const {
    GstState state = GST_STATE_NULL;
    return gst_element_get_state(pipeline_, &state, nullptr, state_patience) == GST_STATE_CHANGE_SUCCESS &&
           state == GST_STATE_PLAYING;
}

bool LoopSeeker::seek(int flags, std::chrono::nanoseconds place) {
    flags |= GST_SEEK_FLAG_ACCURATE | flags_;
    const auto end = end_.value_or(std::chrono::nanoseconds(-1));
    GstEvent* event =
        gst_event_new_seek(1.0, GST_FORMAT_TIME, static_cast<GstSeekFlags>(flags), GST_SEEK_TYPE_SET,
                           place.count(), end_ ? GST_SEEK_TYPE_SET : GST_SEEK_TYPE_NONE, end.count());
    seek_ = gst_event_get_seqnum(event);
    if (announce_) announce_(seek_);
    return gst_element_send_event(pipeline_, event) != FALSE;  // takes the event
}

}  // namespace vitrine::player
