#pragma once

#include "player/playback/reader/reader_host.hpp"
#include "player/playback/reader/reader_link.hpp"
#include "player/playback/sample_queue.hpp"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace vitrine::player {

/// One file that a reader reads: takes its pictures into a queue, in a thread of its own. Throws nothing:
/// failure() reports.
class Reading {
  public:
    /// @param slots  pictures that the reader and the player hold at a time, at most
    /// @param queue  outlives this; closed when no more pictures will come, but not after a photo's picture
    Reading(ReaderHost& host, ReaderOrder order, std::size_t slots, SampleQueue& queue);
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;
    Reading(Reading&&) = delete;
    Reading& operator=(Reading&&) = delete;

    /// Does not wait for the reader.
    ~Reading();

    /// The way to the reader. None: it could not be started.
    ReaderLink* link() { return link_.get(); }

    /// Asks the reader to end.
    void stop();

    /// True once the reader has ended, or a photo's picture has come.
    bool has_ended() const { return has_ended_; }

    std::chrono::nanoseconds spent() const { return spent_; }

    /// The reason why there are no more pictures. None: there may be more, or stop() was called.
    std::optional<std::string> failure() const;

    /// True: the reader has crashed by what it read.
    bool has_crashed() const { return has_crashed_; }

  private:
    void run();
    void set_end(const ReaderEnd& end);

    bool is_photo_;
    SampleQueue& queue_;  // outlives this
    std::unique_ptr<ReaderLink> link_;
    std::atomic<std::chrono::nanoseconds> spent_{std::chrono::nanoseconds(0)};
    std::atomic<bool> is_stopped_ = false;
    std::atomic<bool> has_crashed_ = false;
    std::atomic<bool> has_ended_ = false;
    mutable std::mutex mutex_;
    std::optional<std::string> failure_;  // guarded by mutex_
    std::thread thread_;                  // last: it uses all members above
};

}  // namespace vitrine::player
