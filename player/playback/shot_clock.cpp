#include "player/playback/shot_clock.hpp"

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds max_behind = 250ms;  // then the shot's time is set back
constexpr std::chrono::nanoseconds hopeless = 1s;       // then the film is sent ahead
constexpr std::chrono::nanoseconds jump_time = 300ms;   // the time that a jump takes until the film plays
constexpr std::chrono::nanoseconds between_jumps = 3s;

}  // namespace

ShotClock::ShotClock(bool keeps_time, std::chrono::nanoseconds at)
    : keeps_time_(keeps_time), judged_(at - 1ns), jumped_(at) {}

bool ShotClock::judge(std::chrono::nanoseconds local, std::chrono::nanoseconds missing) {
    if (local == judged_) return false;
    judged_ = local;
    ++due_;
    if (missing <= rounding) return false;
    ++late_;
    if (keeps_time_) return missing > hopeless && local - jumped_ > between_jumps;
    if (missing > max_behind) behind_ += missing;
    return false;
}

std::chrono::nanoseconds ShotClock::jump() {
    jumped_ = judged_;
    return judged_ + jump_time;
}

}  // namespace vitrine::player
