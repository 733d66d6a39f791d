#include "link/message_queue.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace vitrine;
using namespace vitrine::link;

namespace {

WallMessage message(const std::string& topic, std::string payload = "{}") {
    return {.topic = *wall_topic(topic), .payload = std::move(payload)};
}

}  // namespace

TEST_CASE("messages come out in their order") {
    MessageQueue queue;
    queue.put(message("ready/a"));
    queue.put(message("ready/b"));
    CHECK(queue.take()->topic.box == "a");
    CHECK(queue.take()->topic.box == "b");
    CHECK_FALSE(queue.take());
}

TEST_CASE("of acts and of what boxes say of themselves only the newest waits, of touches all") {
    MessageQueue queue;
    for (const char* topic : {"act", "box/a", "act", "touch/a", "box/b", "touch/a", "box/a"})
        queue.put(message(topic));
    CHECK(queue.size() == 5);
    queue.take();
    CHECK(queue.take()->topic.kind == WallTopic::Kind::touch);
}

TEST_CASE("a full queue lets the oldest of those go that are not kept, else the oldest") {
    MessageQueue queue;
    queue.put(message("act", "{\"kept\":1}"));
    for (std::size_t k = 0; k < 2 * MessageQueue::max_messages; ++k)
        queue.put(message("touch/a"));
    CHECK(queue.size() == MessageQueue::max_messages);
    CHECK(queue.take()->payload == "{\"kept\":1}");
    for (std::size_t k = 0; k < 2 * MessageQueue::max_messages; ++k)
        queue.put(message("box/b" + std::to_string(k)));
    CHECK(queue.size() == MessageQueue::max_messages);
    CHECK(queue.take()->topic.box == "b" + std::to_string(MessageQueue::max_messages));
}

TEST_CASE("the bytes that wait are bounded, and those of messages that have left do not count") {
    MessageQueue queue;
    const std::string large(max_wall_line, 'x');
    for (int k = 0; k < 100; ++k) {
        queue.put(message("touch/a", large));
        if (k % 2 == 0) queue.take();
        queue.put(message("act", large));
    }
    CHECK(queue.size() == MessageQueue::max_bytes / max_wall_line);
}
