#include "player/display/output_state.hpp"

#include <cerrno>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto flip_patience = 3s;  // wait for an event that does not come
constexpr auto busy_patience = 3s;  // wait for a card that takes no picture

bool is_passing(int error) {
    return error == EBUSY || error == EINTR || error == EAGAIN;
}

std::optional<Outcome> loss(int error) {
    if (error == EACCES || error == EPERM) return Outcome::no_master;
    if (error == ENODEV || error == ENXIO) return Outcome::no_card;
    return std::nullopt;
}

}  // namespace

Outcome OutputState::mode_answered(int error) {
    needs_mode_ = error != 0;
    if (error == 0) return Outcome::shown;
    if (is_passing(error)) return Outcome::dropped;
    return loss(error).value_or(Outcome::refused);
}

Outcome OutputState::flip_answered(int error, Time now) {
    if (error == 0) {
        flip_since_ = now;
        busy_since_.reset();
        return Outcome::under_way;
    }
    if (is_passing(error)) {
        if (!busy_since_) busy_since_ = now;
        if (now - *busy_since_ > busy_patience) start_over();
        return Outcome::dropped;
    }
    start_over();
    return loss(error).value_or(Outcome::dropped);
}

bool OutputState::flip_arrived() {
    const bool was_waiting = is_waiting();
    flip_since_.reset();
    return was_waiting;
}

bool OutputState::give_up_waiting(Time now) {
    if (!flip_since_ || now - *flip_since_ <= flip_patience) return false;
    start_over();
    return true;
}

void OutputState::start_over() {
    needs_mode_ = true;
    flip_since_.reset();
    busy_since_.reset();
}

}  // namespace vitrine::player
