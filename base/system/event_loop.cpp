#include "base/system/event_loop.hpp"

#include "base/system/error.hpp"

#include <systemd/sd-event.h>

#include <csignal>
#include <utility>

namespace vitrine {

/// Stays at one address for as long as its source lives, because sd-event keeps that address.
struct EventLoop::Callback {
    EventLoop& loop;
    std::function<void(std::uint32_t)> call;

    /// Stops exceptions before they reach C, at this place only. The copy keeps the function alive if it
    /// destroys its own source.
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

/// sd-event returns -errno.
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

EventLoop::Source::Source(Source&& other) noexcept
    : source_(std::exchange(other.source_, nullptr)), callback_(std::move(other.callback_)) {}

EventLoop::Source& EventLoop::Source::operator=(Source&& other) noexcept {
    if (this == &other) return *this;
    reset();
    source_ = std::exchange(other.source_, nullptr);
    callback_ = std::move(other.callback_);
    return *this;
}

EventLoop::Source::~Source() {
    reset();
}

void EventLoop::Source::reset() {
    sd_event_source_disable_unref(std::exchange(source_, nullptr));
    callback_.reset();
}

void EventLoop::Source::arm(Clock::duration delay) {
    checked(sd_event_source_set_time_relative(source_, microseconds(delay)), "set a timer");
    checked(sd_event_source_set_enabled(source_, SD_EVENT_ONESHOT), "arm a timer");
}

void EventLoop::Source::disarm() {
    checked(sd_event_source_set_enabled(source_, SD_EVENT_OFF), "disarm a timer");
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

EventLoop::Source EventLoop::made(Source source, int result, const char* what) const {
    checked(result, what);
    return source;
}

EventLoop::Source EventLoop::watch(int fd, std::uint32_t events, std::function<void(std::uint32_t)> call) {
    Source source;
    source.callback_ = std::make_unique<Callback>(Callback{*this, std::move(call)});
    const int result =
        sd_event_add_io(get(), &source.source_, fd, events, &Callback::on_io, source.callback_.get());
    return made(std::move(source), result, "watch a file descriptor");
}

EventLoop::Source EventLoop::timer(std::function<void()> call) {
    Source source;
    source.callback_ =
        std::make_unique<Callback>(Callback{*this, [call = std::move(call)](std::uint32_t) { call(); }});
    const int result = sd_event_add_time(get(), &source.source_, CLOCK_MONOTONIC, 0, timer_accuracy_us,
                                         &Callback::on_time, source.callback_.get());
    source = made(std::move(source), result, "make a timer");
    source.disarm();
    return source;
}

EventLoop::Source EventLoop::signal(int number, std::function<void()> call) {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, number);
    checked(-pthread_sigmask(SIG_BLOCK, &set, nullptr), "block a signal");
    Source source;
    source.callback_ =
        std::make_unique<Callback>(Callback{*this, [call = std::move(call)](std::uint32_t) { call(); }});
    const int result =
        sd_event_add_signal(get(), &source.source_, number, &Callback::on_signal, source.callback_.get());
    return made(std::move(source), result, "take a signal");
}

EventLoop::Source EventLoop::defer(std::function<void()> call) {
    Source source;
    source.callback_ =
        std::make_unique<Callback>(Callback{*this, [call = std::move(call)](std::uint32_t) { call(); }});
    const int result =
        sd_event_add_defer(get(), &source.source_, &Callback::on_defer, source.callback_.get());
    return made(std::move(source), result, "defer a call");
}

void EventLoop::run() {
    const int result = sd_event_loop(get());
    rethrow();
    checked(result, "wait for events");
}

bool EventLoop::run_once(Clock::duration at_most) {
    const int result = sd_event_run(get(), microseconds(at_most));
    rethrow();
    if (result == -ESTALE) return false;  // the loop has quit
    return checked(result, "wait for events") > 0 && sd_event_get_state(get()) != SD_EVENT_FINISHED;
}

void EventLoop::quit() {
    sd_event_exit(get(), 0);
}

void EventLoop::rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

}  // namespace vitrine
