#pragma once

#include "base/system/message_socket.hpp"
#include "player/playback/reader/reader_messages.hpp"

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// The process that starts the readers, as the player sees it. It is a program of its own, so that a reader
/// knows nothing of the player's memory and holds none of its descriptors. It is started again if it has
/// ended. All readers end with it.
class ReaderHost {
  public:
    /// Starts the process.
    /// @param command  a program and its arguments; the program calls serve_orders() on its standard input
    explicit ReaderHost(std::vector<std::string> command);
    ReaderHost(const ReaderHost&) = delete;
    ReaderHost& operator=(const ReaderHost&) = delete;
    ReaderHost(ReaderHost&&) = delete;
    ReaderHost& operator=(ReaderHost&&) = delete;

    /// Ends the process, and so all readers. Does not wait for a reader that a share keeps from ending.
    ~ReaderHost();

    /// Asks for a reader. Does not wait until it runs.
    /// @param memory  the slots that it writes, for the order's slots
    /// @return the player's end of the socket to the reader
    /// @throws std::system_error, std::runtime_error if no reader can be started
    MessageSocket start_reader(const ReaderOrder& order, const UniqueFd& memory);

    pid_t process() const { return process_; }

  private:
    void start();
    void end();
    bool is_running();

    std::vector<std::string> command_;
    std::optional<MessageSocket> orders_;
    pid_t process_ = -1;
};

}  // namespace vitrine::player
