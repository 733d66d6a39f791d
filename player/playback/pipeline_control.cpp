#include "player/playback/pipeline_control.hpp"

#include <utility>

namespace vitrine::player {

namespace {

constexpr const char* stop_word = "vitrine-stop";

void post_to(GstBus* bus, const char* word) {
    if (bus == nullptr) return;
    GstStructure* content = gst_structure_new_empty(word);
    gst_bus_post(bus, gst_message_new_application(nullptr, content));  // takes the message and its content
}

}  // namespace

bool PipelineControl::attach(GstBus* bus) {
    const std::lock_guard lock(mutex_);
    if (is_stopped_) return false;
    bus_ = bus;
    return true;
}

void PipelineControl::detach() {
    const std::lock_guard lock(mutex_);
    bus_ = nullptr;
}

void PipelineControl::post(const char* word) {
    const std::lock_guard lock(mutex_);
    post_to(bus_, word);
}

void PipelineControl::stop() {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(is_stopped_, true)) post_to(bus_, stop_word);
}

GstPtr<GstMessage> PipelineControl::next_message(GstClockTime patience) const {
    constexpr auto types =
        static_cast<GstMessageType>(GST_MESSAGE_ERROR | GST_MESSAGE_EOS | GST_MESSAGE_SEGMENT_DONE |
                                    GST_MESSAGE_ASYNC_DONE | GST_MESSAGE_APPLICATION);
    GstPtr<GstMessage> message(gst_bus_timed_pop_filtered(bus_, patience, types));
    if (!message || gst_message_has_name(message.get(), stop_word)) return nullptr;
    return message;
}

void PipelineControl::set_failure(PlaybackFailure failure) {
    const std::lock_guard lock(mutex_);
    failure_ = std::move(failure);
}

std::optional<PlaybackFailure> PipelineControl::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

void PipelineControl::set_ended() {
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    ended_.notify_all();
}

bool PipelineControl::has_ended() const {
    const std::lock_guard lock(mutex_);
    return has_ended_;
}

bool PipelineControl::wait_for_end(std::chrono::nanoseconds patience) const {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, patience, [this] { return has_ended_; });
}

GstPtr<GstElement> element_named(GstElement* bin, const char* name) {
    return GstPtr<GstElement>(gst_bin_get_by_name(GST_BIN(bin), name));
}

}  // namespace vitrine::player
