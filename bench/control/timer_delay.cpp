// This library measures how long the busiest timer of a program waits after its time: the player's is its
// tick. The player loads it where users.py asks for that. It stands before sd_event_add_time. At the
// program's end it prints one line:
//   N ticks; MS ms the longest delay, MS ms the longest at work; N ticks over 10 ms at work
// A delay is at work as far as the thread of the timer ran meanwhile, that is, did something else than the
// tick. The rest is the machine's: other threads had the processor.

#include <dlfcn.h>
#include <systemd/sd-event.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <deque>

namespace {

constexpr double max_at_work = 10;  // ms

struct Timer {
    sd_event_time_handler_t handler = nullptr;
    void* data = nullptr;
    long ticks = 0;
    long over = 0;
    double longest_ms = 0;
    double longest_at_work_ms = 0;
    double ran_ms = 0;  // what the thread had run at the end of the last tick
};

double clock_ms(clockid_t clock) {
    timespec time{};
    ::clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

struct Timers {
    std::deque<Timer> all;  // keeps addresses; one thread uses them

    ~Timers() {
        const auto busiest = std::ranges::max_element(all, {}, &Timer::ticks);
        if (busiest == all.end()) return;
        std::fprintf(stderr,
                     "%ld ticks; %.1f ms the longest delay, %.1f ms the longest at work; %ld ticks over %.0f "
                     "ms at work\n",
                     busiest->ticks, busiest->longest_ms, busiest->longest_at_work_ms, busiest->over,
                     max_at_work);
    }
} timers;

int on_time(sd_event_source* source, std::uint64_t due_us, void* data) {
    auto& timer = *static_cast<Timer*>(data);
    const double delay = std::max(0.0, clock_ms(CLOCK_MONOTONIC) - static_cast<double>(due_us) / 1e3);
    const double at_work = std::min(delay, clock_ms(CLOCK_THREAD_CPUTIME_ID) - timer.ran_ms);
    if (timer.ticks++ > 0) {  // before the first tick the program starts
        timer.longest_ms = std::max(timer.longest_ms, delay);
        timer.longest_at_work_ms = std::max(timer.longest_at_work_ms, at_work);
        timer.over += at_work > max_at_work ? 1 : 0;
    }
    const int result = timer.handler(source, due_us, timer.data);
    timer.ran_ms = clock_ms(CLOCK_THREAD_CPUTIME_ID);
    return result;
}

}  // namespace

extern "C" int sd_event_add_time(sd_event* loop, sd_event_source** made, clockid_t clock,
                                 std::uint64_t due_us, std::uint64_t accuracy_us,
                                 sd_event_time_handler_t handler, void* data) {
    static const auto next =
        reinterpret_cast<decltype(&sd_event_add_time)>(::dlsym(RTLD_NEXT, "sd_event_add_time"));
    Timer& timer = timers.all.emplace_back(Timer{.handler = handler, .data = data});
    return next(loop, made, clock, due_us, accuracy_us, &on_time, &timer);
}
