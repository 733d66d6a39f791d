#pragma once

#include "base/system/unique_fd.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace vitrine {

/// A message between two processes, with the descriptors that came with it.
struct Message {
    std::vector<std::byte> bytes;
    std::vector<UniqueFd> files;
};

/// One end of a pair of sockets that carry whole messages between two processes. Thread-safe.
class MessageSocket {
  public:
    static constexpr std::size_t max_bytes = 16U << 10;  // of a message

    explicit MessageSocket(UniqueFd end) : end_(std::move(end)) {}

    int fd() const { return end_.get(); }

    /// Sends a message without waiting. False: the other end is closed or takes no more.
    /// @param files  descriptors that the other process gets as its own
    bool send(std::span<const std::byte> bytes, std::span<const int> files = {}) const;

    /// Waits for the next message. None: the other end is closed or has stopped sending, or end_receiving().
    /// A message that is too long comes without bytes.
    /// @param max_files  descriptors beyond this number are not taken
    std::optional<Message> receive(std::size_t max_files = 0) const;

    /// Tells the other end that no message follows.
    void end_sending() const;

    /// Ends the waiting in receive(), in any thread, for good.
    void end_receiving() const;

  private:
    UniqueFd end_;
};

/// The two ends of a new pair. @throws std::system_error
std::pair<MessageSocket, MessageSocket> message_sockets();

}  // namespace vitrine
