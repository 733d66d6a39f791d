#include "link/link.hpp"

#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"
#include "base/system/service.hpp"
#include "base/wall/broken_line.hpp"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <utility>

namespace vitrine::link {

namespace {

constexpr std::size_t max_topics = 2 * Link::max_boxes + 2;  // box and ready of each, act and prepare
constexpr auto summary_pause =
    std::chrono::seconds(10);  // between two lines of the log about refused messages

}  // namespace

Link::Link(EventLoop& loop, const BrokerAccount& account, const std::filesystem::path& socket)
    : place_(account.place),
      wanted_(socket.parent_path() / "wanted"),
      summary_(loop.timer([this] { sum_up(); })),
      players_(loop, socket,
               {.begin = [this](LineListener::Id id) { greet(id); },
                .line = [this](LineListener::Id, const std::string& line) { send(line); },
                .end = [this](LineListener::Id, const std::string& why) { leave(why); }}),
      broker_(
          loop, account,
          {.state = [this](bool is_connected, const std::string& says) { follow_state(is_connected, says); },
           .message = [this](const WallMessage& message) { hear(message); },
           .refused = [this](const std::string& fault) { refuse(fault); }}) {}

/// A player that starts learns at once what the boxes have last said.
void Link::greet(LineListener::Id player) {
    log::info("the player is here");
    players_.send(player, line_of({.topic = {}, .payload = link_payload(is_connected_, says_)}));
    for (const auto& [topic, message] : heard_)
        players_.send(player, line_of(message));
}

/// A line of the player. @throws BrokenLine
void Link::send(const std::string& line) {
    WallMessage message = wall_message(line);
    check_sent(place_, message);
    if (is_kept(message.topic.kind)) sent_.insert_or_assign(text_of(message.topic), message);
    broker_.publish(message);
}

/// Other boxes need not wait for a box whose player is gone.
void Link::leave(const std::string& why) {
    log::warning("the player is gone: {}", why);
    const WallTopic topic{.kind = WallTopic::Kind::box, .box = place_.box};
    if (players_.connections() > 0 || sent_.erase(text_of(topic)) == 0) return;
    broker_.publish({.topic = topic, .is_retained = true, .payload = R"({"gone":true})"});
}

void Link::follow_state(bool is_connected, const std::string& says) {
    if (says != says_) log::write(is_connected ? log::Level::info : log::Level::warning, says);
    is_connected_ = is_connected;
    says_ = says;
    tell_state();
    if (!is_connected) return;
    for (const auto& [topic, message] : sent_)  // the broker may have been started anew, with nothing kept
        broker_.publish(message);
}

void Link::tell_state() {
    service::status(says_);
    players_.send_all(line_of({.topic = {}, .payload = link_payload(is_connected_, says_)}));
}

void Link::hear(const WallMessage& message) {
    try {
        WallMessage read = checked(message);
        const std::string topic = text_of(read.topic);
        if (is_kept(read.topic.kind)) {
            if (!heard_.contains(topic) && heard_.size() >= max_topics)
                throw BrokenLine(
                    fmt::format("a wall has at most {} boxes; '{}' is one more", max_boxes, topic));
            heard_.insert_or_assign(topic, read);
        }
        players_.send_all(line_of(read));
        if (read.topic.kind == WallTopic::Kind::prepare || tells_other_tapestry(read)) want_files();
    } catch (const BrokenLine& broken) {
        refuse(broken.what());
    }
}

/// Tells the first of many at once, and the number of the others later.
void Link::refuse(const std::string& fault) {
    if (refused_++ > 0) return;
    log::warning("a message is refused: {}", fault);
    players_.send_all(line_of({.topic = {}, .payload = link_payload(is_connected_, fault)}));
    summary_.arm(summary_pause);
}

void Link::sum_up() {
    if (refused_ > 1) log::warning("{} more messages were refused", refused_ - 1);
    refused_ = 0;
}

/// True if hands have opened a tapestry that the last message has not told of, or more of it is woven.
bool Link::tells_other_tapestry(const WallMessage& message) {
    if (message.topic.kind != WallTopic::Kind::lifted) return false;
    const std::string last = std::exchange(tapestry_, told_tapestry(message.payload));
    return !tapestry_.empty() && tapestry_ != last;
}

/// Wakes vitrine-wall-fetch.path, which fetches the files that are needed next.
void Link::want_files() const {
    try {
        replace_file_unsynced(wanted_, "\n");
    } catch (const std::exception& error) {
        log::warning("the fetching of files is not started: {}", error.what());
    }
}

}  // namespace vitrine::link
