#include "player/playback/watchdog.hpp"

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds patience = 2s;
constexpr std::chrono::nanoseconds forgiven_after = 60s;  // after this time without starving
constexpr int max_rebuilds = 3;                           // with the first decoder

}  // namespace

Watchdog::Verdict Watchdog::judge(bool is_starved, std::chrono::nanoseconds now) {
    if (!is_starved) {
        starved_.reset();
        if (!fine_) fine_ = now;
        if (now - *fine_ >= forgiven_after) rebuilds_ = 0;
        return Verdict::fine;
    }
    fine_.reset();
    if (!starved_) starved_ = now;
    if (now - *starved_ < patience) return Verdict::fine;
    starved_ = now;
    ++rebuilds_;
    if (rebuilds_ <= max_rebuilds) return Verdict::rebuild;
    return rebuilds_ == max_rebuilds + 1 ? Verdict::rebuild_in_software : Verdict::give_up;
}

}  // namespace vitrine::player
