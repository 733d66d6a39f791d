#include "player/display/output_state.hpp"

#include <doctest/doctest.h>

#include <cerrno>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

const OutputState::Time start{100s};

// The state of a panel that is lit.
OutputState lit() {
    OutputState state;
    REQUIRE(state.mode_answered(0) == Outcome::shown);
    return state;
}

}  // namespace

TEST_CASE("the first picture comes with the mode, the next ones are flips") {
    OutputState state;
    CHECK(state.needs_mode());
    CHECK(state.mode_answered(0) == Outcome::shown);
    CHECK_FALSE(state.needs_mode());
    CHECK_FALSE(state.is_waiting());

    CHECK(state.flip_answered(0, start) == Outcome::under_way);
    CHECK(state.is_waiting());
    CHECK(state.flip_arrived());
    CHECK_FALSE(state.is_waiting());
    CHECK_FALSE(state.needs_mode());
}

TEST_CASE("a card that is busy with a mode is asked again, in the same mode") {
    OutputState state;
    CHECK(state.mode_answered(EBUSY) == Outcome::dropped);
    CHECK(state.needs_mode());
    CHECK(state.mode_answered(0) == Outcome::shown);
}

TEST_CASE("a card that is busy with a flip is given the next picture: nothing is waited for") {
    OutputState state = lit();
    CHECK(state.flip_answered(EBUSY, start) == Outcome::dropped);
    CHECK_FALSE(state.is_waiting());
    CHECK_FALSE(state.needs_mode());
    CHECK(state.flip_answered(0, start + 33ms) == Outcome::under_way);
}

TEST_CASE("a card that stays busy for seconds is given the mode again, one that is busy at times is not") {
    OutputState state = lit();
    for (auto time = 0ms; time <= 3000ms; time += 100ms)
        CHECK(state.flip_answered(EBUSY, start + time) == Outcome::dropped);
    CHECK_FALSE(state.needs_mode());
    CHECK(state.flip_answered(EBUSY, start + 3100ms) == Outcome::dropped);
    CHECK(state.needs_mode());

    OutputState at_times = lit();
    for (auto time = 0ms; time <= 10s; time += 100ms) {
        at_times.flip_answered(time.count() % 1000 == 0 ? 0 : EBUSY, start + time);
        at_times.flip_arrived();
    }
    CHECK_FALSE(at_times.needs_mode());
}

TEST_CASE("a mode that the card refuses is told, so that another one is tried") {
    for (const int error : {EINVAL, ERANGE, ENOSPC, ENOMEM}) {
        OutputState state;
        CHECK(state.mode_answered(error) == Outcome::refused);
        CHECK(state.needs_mode());
    }
}

TEST_CASE("a flip that is refused, as after another program has set a mode, has the mode set again") {
    OutputState state = lit();
    CHECK(state.flip_answered(EINVAL, start) == Outcome::dropped);
    CHECK(state.needs_mode());
    CHECK_FALSE(state.is_waiting());
}

TEST_CASE("the loss of the card to another program is told, and the mode set when it is ours again") {
    for (const int error : {EACCES, EPERM}) {
        OutputState state = lit();
        CHECK(state.flip_answered(error, start) == Outcome::no_master);
        CHECK(state.needs_mode());
        CHECK(state.mode_answered(error) == Outcome::no_master);
        CHECK(state.mode_answered(0) == Outcome::shown);
    }
}

TEST_CASE("the loss of the card itself is told") {
    OutputState state = lit();
    CHECK(state.flip_answered(ENODEV, start) == Outcome::no_card);
    CHECK(state.mode_answered(ENODEV) == Outcome::no_card);
}

TEST_CASE("an event that does not come is given up for the mode, after a while") {
    OutputState state = lit();
    CHECK_FALSE(state.give_up_waiting(start));
    state.flip_answered(0, start);

    CHECK_FALSE(state.give_up_waiting(start + 2s));
    CHECK(state.is_waiting());
    CHECK(state.give_up_waiting(start + 4s));
    CHECK_FALSE(state.is_waiting());
    CHECK(state.needs_mode());
    CHECK_FALSE(state.flip_arrived());  // too late
}
