#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>

struct sd_event;
struct sd_event_source;

namespace vitrine {

/// Waits for files, times and signals in one thread and calls back, over sd-event.
///
/// An exception of a callback ends the loop and comes out of run(); it never crosses sd-event itself.
class EventLoop {
    struct Callback;

  public:
    using Clock = std::chrono::steady_clock;

    /// What a callback hangs on: nothing is called any more once it is gone. Must not outlive the loop.
    /// A callback may destroy its own source as its last deed.
    class [[nodiscard]] Source {
      public:
        Source();
        Source(Source&&) noexcept;
        Source& operator=(Source&&) noexcept;
        Source(const Source&) = delete;
        Source& operator=(const Source&) = delete;
        ~Source();

        bool is_set() const { return source_ != nullptr; }

        /// Timers only: calls back once, this long from now, whether it already did or not.
        void arm(Clock::duration delay);

        void disarm();

      private:
        friend class EventLoop;
        void reset();

        sd_event_source* source_ = nullptr;
        std::unique_ptr<Callback> callback_;
    };

    EventLoop();
    EventLoop(const EventLoop&) = delete;
    EventLoop& operator=(const EventLoop&) = delete;
    EventLoop(EventLoop&&) = delete;
    EventLoop& operator=(EventLoop&&) = delete;
    ~EventLoop();

    /// @param events  EPOLLIN, EPOLLOUT; the callback gets those that came, with EPOLLHUP and EPOLLERR
    /// @param fd      borrowed: open for as long as the source lives
    Source watch(int fd, std::uint32_t events, std::function<void(std::uint32_t)> call);

    /// A timer, not armed yet.
    Source timer(std::function<void()> call);

    /// Blocks the signal for this thread and takes it in turn with everything else.
    Source signal(int number, std::function<void()> call);

    /// Calls once, as soon as the loop runs.
    Source defer(std::function<void()> call);

    /// Runs until quit(). @throws what a callback threw
    void run();

    /// Waits for one event at most this long and deals with it. @return false where none came or the loop
    /// quit
    bool run_once(Clock::duration at_most);

    void quit();

    /// For a library that brings its own sd-event sources.
    sd_event* get() const { return event_.get(); }

  private:
    Source made(Source source, int result, const char* what) const;
    void rethrow();

    struct Unref {
        void operator()(sd_event* event) const;
    };

    std::unique_ptr<sd_event, Unref> event_;
    std::exception_ptr thrown_;
};

}  // namespace vitrine
