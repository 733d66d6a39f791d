#include "base/system/event_loop.hpp"

#include "base/system/error.hpp"

#include <systemd/sd-event.h>

#include <csignal>
#include <utility>

namespace vitrine {

/// Stays at one address while its source lives, because sd-event keeps that address.
struct EventLoop::Callback {
    Callback(EventLoop& its_loop, std::function<void(std::uint32_t)> its_call)
        : loop(its_loop), call(std::move(its_call)) {}

    Callback(const Callback&) = delete;
    Callback& operator=(const Callback&) = delete;

    ~Callback() { sd_event_source_disable_unref(source); }

    EventLoop& loop;
    std::function<void(std::uint32_t)> call;
    sd_event_source* source = nullptr;

    /// Stops exceptions before they reach C. Only this function does so. The copy keeps the function alive if
    /// it destroys its own source.
    int guarded(std::uint32_t events) const {
        EventLoop& keeper = loop;
        try {
            const auto copy = call;
            copy(events);
        } catch (...) {
            keeper.thrown_ = std::current_exception();
            keeper.quit();
        }
        return 0;
    }

    static int on_io(sd_event_source*, int, std::uint32_t events, void* self) {
        return static_cast<Callback*>(self)->guarded(events);
    }

    static int on_time(sd_event_source*, std::uint64_t, void* self) {
        return static_cast<Callback*>(self)->guarded(0);
    }

    static int on_signal(sd_event_source*, const signalfd_siginfo*, void* self) {
        return static_cast<Callback*>(self)->guarded(0);
    }

    static int on_defer(sd_event_source*, void* self) { return static_cast<Callback*>(self)->guarded(0); }
};

namespace {

/// Throws for a result of sd-event, which returns -errno.
int checked(int result, const char* what) {
    if (result >= 0) return result;
    errno = -result;
    throw_errno("{}", what);
}

std::uint64_t microseconds(EventLoop::Clock::duration duration) {
    const auto whole = std::chrono::ceil<std::chrono::microseconds>(duration).count();
    return whole < 0 ? 0 : static_cast<std::uint64_t>(whole);
}

constexpr std::uint64_t timer_accuracy_us = 1000;

}  // namespace

EventLoop::Source::Source() = default;

EventLoop::Source::Source(std::unique_ptr<Callback> callback) : callback_(std::move(callback)) {}

EventLoop::Source::Source(Source&&) noexcept = default;
EventLoop::Source& EventLoop::Source::operator=(Source&&) noexcept = default;
EventLoop::Source::~Source() = default;

sd_event_source* EventLoop::Source::source() const {
    return callback_ ? callback_->source : nullptr;
}

void EventLoop::Source::arm(Clock::duration delay) {
    checked(sd_event_source_set_time_relative(source(), microseconds(delay)), "set a timer");
    checked(sd_event_source_set_enabled(source(), SD_EVENT_ONESHOT), "arm a timer");
}

void EventLoop::Source::disarm() {
    checked(sd_event_source_set_enabled(source(), SD_EVENT_OFF), "disarm a timer");
}

void EventLoop::Unref::operator()(sd_event* event) const {
    sd_event_unref(event);
}

EventLoop::EventLoop() {
    sd_event* event = nullptr;
    checked(sd_event_new(&event), "make an event loop");
    event_.reset(event);
}

EventLoop::~EventLoop() = default;

std::unique_ptr<EventLoop::Callback> EventLoop::new_callback(std::function<void()> call) {
    return std::make_unique<Callback>(*this, [call = std::move(call)](std::uint32_t) { call(); });
}

EventLoop::Source EventLoop::watch(int fd, std::uint32_t events, std::function<void(std::uint32_t)> call) {
    auto callback = std::make_unique<Callback>(*this, std::move(call));
    checked(sd_event_add_io(get(), &callback->source, fd, events, &Callback::on_io, callback.get()),
            "watch a file descriptor");
    return Source(std::move(callback));
}

EventLoop::Source EventLoop::timer(std::function<void()> call) {
    auto callback = new_callback(std::move(call));
    checked(sd_event_add_time(get(), &callback->source, CLOCK_MONOTONIC, 0, timer_accuracy_us,
                              &Callback::on_time, callback.get()),
            "make a timer");
    Source source(std::move(callback));
    source.disarm();
    return source;
}

EventLoop::Source EventLoop::signal(int number, std::function<void()> call) {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, number);
    checked(-pthread_sigmask(SIG_BLOCK, &set, nullptr), "block a signal");
    auto callback = new_callback(std::move(call));
    checked(sd_event_add_signal(get(), &callback->source, number, &Callback::on_signal, callback.get()),
            "take a signal");
    return Source(std::move(callback));
}

EventLoop::Source EventLoop::defer(std::function<void()> call) {
    auto callback = new_callback(std::move(call));
    checked(sd_event_add_defer(get(), &callback->source, &Callback::on_defer, callback.get()),
            "defer a call");
    return Source(std::move(callback));
}

void EventLoop::run() {
    const int result = sd_event_loop(get());
    rethrow();
    checked(result, "wait for events");
}

bool EventLoop::run_once(Clock::duration max_wait) {
    const int result = sd_event_run(get(), microseconds(max_wait));
    rethrow();
    if (result == -ESTALE) return false;  // the loop was told to quit
    return checked(result, "wait for events") > 0 && sd_event_get_state(get()) != SD_EVENT_FINISHED;
}

void EventLoop::quit() {
    sd_event_exit(get(), 0);
}

void EventLoop::rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

}  // namespace vitrine
