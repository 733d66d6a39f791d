#include "link/message_rules.hpp"

#include "base/wall/broken_line.hpp"

#include <fmt/format.h>

#include <utility>

namespace vitrine::link {

namespace {

constexpr int known_version = 1;                // of acts and of what they need
constexpr std::size_t max_topic_in_words = 80;  // bytes

std::string in_words(std::string_view topic) {
    return std::string(topic.substr(0, max_topic_in_words));
}

std::string prefix_of(const WallPlace& place) {
    return "vitrine/" + place.wall + "/";
}

/// True if a box of this part listens to messages of this kind.
bool hears(const WallPlace& place, WallTopic::Kind kind) {
    if (kind == WallTopic::Kind::box) return true;
    if (kind == WallTopic::Kind::link) return false;
    return is_of_leader(kind) != place.is_leader;
}

}  // namespace

std::vector<std::string> subscriptions_of(const WallPlace& place) {
    const std::string prefix = prefix_of(place);
    if (place.is_leader) return {prefix + "ready/+", prefix + "touch/+", prefix + "box/+"};
    return {prefix + "act", prefix + "prepare", prefix + "lifted", prefix + "box/+"};
}

std::string broker_topic(const WallPlace& place, const WallTopic& topic) {
    return prefix_of(place) + text_of(topic);
}

WallMessage received(const WallPlace& place, std::string_view topic, std::string_view payload) {
    const std::string prefix = prefix_of(place);
    if (!topic.starts_with(prefix))
        throw BrokenLine(fmt::format("a message of another wall came, '{}'", in_words(topic)));
    const auto read = wall_topic(topic.substr(prefix.size()));
    if (!read || !hears(place, read->kind))
        throw BrokenLine(fmt::format("a message came that this box does not know, '{}'", in_words(topic)));
    if (payload.size() > max_wall_line)
        throw BrokenLine(fmt::format("a message '{}' has {} bytes, more than {}", in_words(topic),
                                     payload.size(), max_wall_line));
    return {.topic = *read, .is_retained = false, .payload = std::string(payload)};
}

WallMessage checked(WallMessage message) {
    message.payload = checked_payload(message.payload);
    if (!is_of_leader(message.topic.kind)) return message;
    const auto version = payload_version(message.payload);
    if (!version) throw BrokenLine(fmt::format("a message '{}' tells no version", text_of(message.topic)));
    if (*version != known_version)
        throw BrokenLine(
            fmt::format("the leader speaks version {} of Vitrine's acts and this box version {}: both need "
                        "the same package",
                        *version, known_version));
    return message;
}

void check_sent(const WallPlace& place, const WallMessage& message) {
    const std::string topic = text_of(message.topic);
    if (message.topic.kind == WallTopic::Kind::link)
        throw BrokenLine("the player sends the state of the link, which is not its to send");
    if (message.topic.kind != WallTopic::Kind::box && is_of_leader(message.topic.kind) != place.is_leader)
        throw BrokenLine(fmt::format("the player sends '{}', which is for {}", topic,
                                     place.is_leader ? "followers" : "the leader"));
    if (!message.topic.box.empty() && message.topic.box != place.box)
        throw BrokenLine(fmt::format("the player sends '{}', but this box is '{}'", topic, place.box));
}

}  // namespace vitrine::link
