#pragma once

#include "base/system/event_loop.hpp"
#include "base/system/unique_fd.hpp"
#include "player/control/bus_messages.hpp"

#include <functional>
#include <future>
#include <list>
#include <memory>
#include <thread>
#include <vector>

namespace vitrine::player {

/// Answers calls for pictures. A thread makes the pictures and writes them into files: this takes tens of
/// milliseconds, in which the loop's thread could not draw.
class PictureAnswers {
  public:
    /// @param loop  outlives this
    explicit PictureAnswers(EventLoop& loop);

    /// Answers a call later, from the loop. @param make  called in a thread; what it throws is the answer
    void answer(sd_bus_message& call, std::function<std::vector<OutputPicture>()> make);

    /// Drops all calls without an answer: their bus is gone. Waits for the threads.
    void drop_calls() { calls_.clear(); }

  private:
    struct Call {
        std::shared_ptr<sd_bus_message> message;  // used by the loop's thread alone
        std::future<std::vector<PictureFile>> files;
        std::jthread thread;
    };

    void send_answers();

    UniqueFd made_;  // an event_file(): the files of a call are made
    EventLoop::Source told_;
    std::list<Call> calls_;  // last: their threads end before the rest
};

}  // namespace vitrine::player
