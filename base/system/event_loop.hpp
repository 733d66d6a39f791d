#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>

struct sd_event;
struct sd_event_source;

namespace vitrine {

/// Waits for files, times and signals in one thread and calls functions (sd-event).
///
/// An exception from a callback ends the loop, and run() throws it again. It never passes through sd-event.
class EventLoop {
    struct Callback;

  public:
    using Clock = std::chrono::steady_clock;

    /// Owns a callback: once it is destroyed, the callback is not called any more. It must not outlive the
    /// loop. A callback may destroy its own source as its last action.
    class [[nodiscard]] Source {
      public:
        Source();
        explicit Source(std::unique_ptr<Callback> callback);  // made by the loop
        Source(Source&&) noexcept;
        Source& operator=(Source&&) noexcept;
        Source(const Source&) = delete;
        Source& operator=(const Source&) = delete;
        ~Source();

        /// For timers: calls back once, after this delay from now, even if it did so before.
        void arm(Clock::duration delay);

        void disarm();

      private:
        sd_event_source* source() const;

        std::unique_ptr<Callback> callback_;
    };

    EventLoop();
    EventLoop(const EventLoop&) = delete;
    EventLoop& operator=(const EventLoop&) = delete;
    EventLoop(EventLoop&&) = delete;
    EventLoop& operator=(EventLoop&&) = delete;
    ~EventLoop();

    /// @param events  EPOLLIN, EPOLLOUT; the callback gets the events that came, with EPOLLHUP and EPOLLERR
    /// @param fd      borrowed: keep it open for as long as the source lives
    Source watch(int fd, std::uint32_t events, std::function<void(std::uint32_t)> call);

    /// Makes a timer that is not armed yet.
    Source timer(std::function<void()> call);

    /// Blocks the signal for this thread, and calls back in turn with all other events.
    Source signal(int number, std::function<void()> call);

    /// Calls back once, as soon as the loop runs.
    Source defer(std::function<void()> call);

    /// Runs until quit(). @throws the exception of a callback
    void run();

    /// Waits for one event, at most this long, and handles it. @return  false if no event came or the loop
    /// quit
    bool run_once(Clock::duration max_wait);

    void quit();

    /// The sd-event loop, for a library that adds its own sources.
    sd_event* get() const { return event_.get(); }

  private:
    std::unique_ptr<Callback> new_callback(std::function<void()> call);
    void rethrow();

    struct Unref {
        void operator()(sd_event* event) const;
    };

    std::unique_ptr<sd_event, Unref> event_;
    std::exception_ptr thrown_;
};

}  // namespace vitrine
