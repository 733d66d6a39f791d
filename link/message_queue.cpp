#include "link/message_queue.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::link {

bool is_of_a_moment(WallTopic::Kind kind) {
    return kind == WallTopic::Kind::touch || kind == WallTopic::Kind::lifted;
}

bool is_kept(WallTopic::Kind kind) {
    return !is_of_a_moment(kind) && kind != WallTopic::Kind::link;
}

void MessageQueue::put(WallMessage message) {
    bytes_ += message.payload.size();
    const auto same = std::ranges::find_if(messages_, [&](const WallMessage& other) {
        return is_kept(message.topic.kind) && other.topic.kind == message.topic.kind &&
               other.topic.box == message.topic.box;
    });
    if (same != messages_.end()) {
        bytes_ -= same->payload.size();
        messages_.erase(same);
    }
    messages_.push_back(std::move(message));
    while (messages_.size() > max_messages || bytes_ > max_bytes)
        drop_oldest();
}

void MessageQueue::drop_oldest() {
    auto oldest = std::ranges::find_if(
        messages_, [](const WallMessage& message) { return !is_kept(message.topic.kind); });
    if (oldest == messages_.end()) oldest = messages_.begin();
    bytes_ -= oldest->payload.size();
    messages_.erase(oldest);
}

std::optional<WallMessage> MessageQueue::take() {
    if (messages_.empty()) return std::nullopt;
    WallMessage message = std::move(messages_.front());
    messages_.pop_front();
    bytes_ -= message.payload.size();
    return message;
}

}  // namespace vitrine::link
