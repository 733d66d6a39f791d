#include "player/playback/sound/sound_timeline.hpp"

#include <algorithm>

namespace vitrine::player {

void SoundTimeline::expect(std::uint32_t seek, std::int64_t loop) {
    const std::lock_guard lock(mutex_);
    loops_[seek] = loop;
}

GstPtr<GstEvent> SoundTimeline::placed(GstEvent* segment, bool is_stamped) {
    const std::uint32_t seek = gst_event_get_seqnum(segment);
    GstSegment place;
    gst_event_copy_segment(segment, &place);
    const std::uint64_t at =
        is_stamped ? place.start : gst_segment_to_stream_time(&place, GST_FORMAT_TIME, place.start);
    const std::lock_guard lock(mutex_);
    if (const auto found = loops_.find(seek); found != loops_.end()) {
        loop_ = found->second;
        loops_.erase(loops_.begin(), found);  // earlier loops are over
    }
    const std::chrono::nanoseconds local = loop_ * duration_ + std::chrono::nanoseconds(at) - begin_;
    place.base = static_cast<std::uint64_t>(std::max(std::chrono::nanoseconds(0), local).count());
    place.offset = 0;
    GstPtr<GstEvent> event(gst_event_new_segment(&place));
    gst_event_set_seqnum(event.get(), seek);
    return event;
}

}  // namespace vitrine::player
