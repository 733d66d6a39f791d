#include "base/system/message_socket.hpp"

#include "base/system/error.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace vitrine {

namespace {

constexpr std::size_t most_files = 4;  // beside one message

/// Room for the descriptors beside a message, as the kernel reads and writes them.
struct FileRoom {
    alignas(cmsghdr) std::array<std::byte, CMSG_SPACE(most_files * sizeof(int))> bytes{};
};

std::vector<UniqueFd> files_in(msghdr& header) {
    std::vector<UniqueFd> files;
    for (cmsghdr* part = CMSG_FIRSTHDR(&header); part != nullptr; part = CMSG_NXTHDR(&header, part)) {
        if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_RIGHTS) continue;
        const std::size_t count = (part->cmsg_len - CMSG_LEN(0)) / sizeof(int);
        for (std::size_t i = 0; i < count; ++i) {
            int file = -1;
            std::memcpy(&file, CMSG_DATA(part) + i * sizeof(int), sizeof file);
            files.emplace_back(file);
        }
    }
    return files;
}

}  // namespace

bool MessageSocket::send(std::span<const std::byte> bytes, std::span<const int> files) const {
    iovec content{.iov_base = const_cast<std::byte*>(bytes.data()), .iov_len = bytes.size()};
    msghdr header{};
    header.msg_iov = &content;
    header.msg_iovlen = 1;
    FileRoom room;
    if (!files.empty() && files.size() <= most_files) {
        header.msg_control = room.bytes.data();
        header.msg_controllen = CMSG_SPACE(files.size_bytes());
        cmsghdr* const part = CMSG_FIRSTHDR(&header);
        part->cmsg_level = SOL_SOCKET;
        part->cmsg_type = SCM_RIGHTS;
        part->cmsg_len = CMSG_LEN(files.size_bytes());
        std::memcpy(CMSG_DATA(part), files.data(), files.size_bytes());
    }
    while (true) {
        const ssize_t sent = ::sendmsg(end_.get(), &header, MSG_DONTWAIT | MSG_NOSIGNAL);
        if (sent >= 0 || errno != EINTR) return sent >= 0;
    }
}

std::optional<Message> MessageSocket::receive(std::size_t max_files) const {
    Message message;
    message.bytes.resize(max_bytes);
    iovec content{.iov_base = message.bytes.data(), .iov_len = message.bytes.size()};
    msghdr header{};
    header.msg_iov = &content;
    header.msg_iovlen = 1;
    FileRoom room;
    if (max_files > 0) {
        header.msg_control = room.bytes.data();
        header.msg_controllen = CMSG_SPACE(std::min(max_files, most_files) * sizeof(int));
    }
    ssize_t got = -1;
    // An end that closes with messages unread resets the connection. The kernel tells that once, before the
    // last messages of that end.
    do
        got = ::recvmsg(end_.get(), &header, MSG_CMSG_CLOEXEC);
    while (got < 0 && (errno == EINTR || errno == ECONNRESET));
    if (got <= 0) return std::nullopt;
    if (max_files > 0) message.files = files_in(header);
    message.bytes.resize((header.msg_flags & MSG_TRUNC) != 0 ? 0 : static_cast<std::size_t>(got));
    return message;
}

void MessageSocket::end_sending() const {
    ::shutdown(end_.get(), SHUT_WR);
}

void MessageSocket::end_receiving() const {
    ::shutdown(end_.get(), SHUT_RD);
}

std::pair<MessageSocket, MessageSocket> message_sockets() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) < 0)
        throw_errno("make a pair of sockets");
    return {MessageSocket(UniqueFd(ends[0])), MessageSocket(UniqueFd(ends[1]))};
}

}  // namespace vitrine
