#pragma once

#include "base/system/message_socket.hpp"
#include "player/playback/film_feed.hpp"
#include "player/playback/reader/picture_intake.hpp"
#include "player/playback/reader/reader_messages.hpp"
#include "player/playback/sample_queue.hpp"

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace vitrine::player {

/// A picture of a reader, with the processor time that the pictures so far have cost.
struct ReaderPicture {
    LoopedSample picture;
    std::chrono::nanoseconds spent{0};
};

/// The reason for which a reader has ended.
struct ReaderEnd {
    std::string text;          // in plain words
    bool has_crashed = false;  // by what it read, not by a kill from outside
};

/// The player's end of one reader. One thread calls next(); all other methods are thread-safe.
class ReaderLink {
  public:
    /// @param reader  the player's end of the socket
    /// @param memory  for the order's slots
    ReaderLink(MessageSocket reader, const ReaderOrder& order, const UniqueFd& memory);

    /// Changes the size of the pictures to come.
    void resize(int width, int height);

    void play_from(Detail detail, std::chrono::nanoseconds at);

    /// Asks the host to end the reader. next() then waits for its end.
    void stop() const { socket_->end_sending(); }

    /// Ends the waiting in next() for good, whatever the reader does.
    void leave() const { socket_->end_receiving(); }

    /// Waits for the next picture. None: the reader has ended, or is not followed any more: see end().
    std::optional<ReaderPicture> next();

    /// The reason for which the reader has ended. It is known once next() has given nothing.
    const ReaderEnd& end() const { return end_; }

  private:
    std::optional<ReaderPicture> picture_in(const Message& message);
    bool is_end(const Message& message);

    std::shared_ptr<const MessageSocket> socket_;  // shared with the pictures, which give back their slots
    PictureForm form_;
    std::mutex mutex_;
    PictureIntake intake_;      // guarded by mutex_
    SlotShape slots_;           // guarded by mutex_; of the newest memory
    std::uint32_t memory_ = 0;  // guarded by mutex_; its number
    ReaderEnd end_;
};

}  // namespace vitrine::player
