#include "base/system/message_socket.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string_view>
#include <thread>

using namespace vitrine;

namespace {

std::span<const std::byte> raw(std::string_view text) {
    return std::as_bytes(std::span(text));
}

}  // namespace

TEST_CASE("messages arrive whole, in order, and with their descriptors") {
    const auto [one, other] = message_sockets();
    const std::array<int, 1> files{one.fd()};
    CHECK(one.send(raw("first")));
    CHECK(one.send(raw("second!"), files));
    CHECK(other.receive(1)->bytes.size() == 5);
    const std::optional<Message> second = other.receive(1);
    CHECK(second->bytes.size() == 7);
    CHECK(second->files.size() == 1);
}

TEST_CASE("descriptors that nobody asked for are not taken, and a message that is too long has no bytes") {
    const auto [one, other] = message_sockets();
    const std::array<int, 1> files{one.fd()};
    CHECK(one.send(raw("text"), files));
    CHECK(other.receive()->files.empty());
    CHECK(one.send(std::vector<std::byte>(MessageSocket::max_bytes + 1)));
    CHECK(other.receive()->bytes.empty());
}

TEST_CASE("the end of one side ends the waiting of the other, and one's own end one's own") {
    auto sockets = message_sockets();
    auto& one = sockets.first;
    auto& other = sockets.second;
    std::thread waiting([&] { CHECK_FALSE(other.receive()); });
    one.end_sending();
    waiting.join();
    CHECK(other.send(raw("still")));
    CHECK(one.receive());
    std::thread leaving([&] { CHECK_FALSE(one.receive()); });
    one.end_receiving();
    leaving.join();
    CHECK_FALSE(other.send(raw("too late")));
}

TEST_CASE("the last word of a side is heard though it has left messages unread") {
    auto [one, other] = message_sockets();
    CHECK(one.send(raw("nobody reads this")));
    CHECK(other.send(raw("the last")));
    other = MessageSocket(UniqueFd());
    CHECK(one.receive());
    CHECK_FALSE(one.receive());
}
