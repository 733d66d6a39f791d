#include "analyzer/watch/attempts.hpp"

#include <doctest/doctest.h>

using namespace vitrine::analyzer;
using namespace std::chrono_literals;

namespace {

const Pace pace{.first_retry = 5s, .max_retry = 1h};

/// Only the verdict.
Verdict verdict(Attempts& attempts, Answer answer, const Attempts::Circumstances& circumstances = {}) {
    return attempts.note_answer(answer, circumstances, pace).verdict;
}

}  // namespace

TEST_CASE("what is not the file's fault is tried again for ever, ever more rarely") {
    Attempts attempts;
    std::chrono::milliseconds expected = 5s;
    for (int i = 0; i < 1000; ++i) {
        const Attempts::Next next = attempts.note_answer(Answer::postponed, {}, pace);
        REQUIRE(next.verdict == Verdict::postpone);
        REQUIRE(next.retry_after == expected);
        expected = std::min<std::chrono::milliseconds>(2 * expected, 1h);
    }
    CHECK(attempts.is_waiting());
    CHECK_FALSE(attempts.is_last(pace));  // the tries of a file that is not complete are others
    CHECK(verdict(attempts, Answer::final) == Verdict::store);
    CHECK_FALSE(attempts.is_waiting());
}

TEST_CASE("a second crash is the file's fault, unless readers of other files crashed too") {
    Attempts attempts;
    CHECK(verdict(attempts, Answer::died) == Verdict::retry);
    CHECK(verdict(attempts, Answer::died, {.have_others_died = true}) == Verdict::postpone);
    CHECK(verdict(attempts, Answer::died, {.have_others_died = true}) == Verdict::postpone);
    CHECK(verdict(attempts, Answer::died) == Verdict::quarantine);
    CHECK(verdict(attempts, Answer::died) == Verdict::retry);  // after the quarantine
}

TEST_CASE("a file on a share is damaged only when it is so twice, one on a disk at once") {
    Attempts local;
    CHECK(verdict(local, Answer::damaged) == Verdict::store);
    Attempts remote;
    const Attempts::Next first = remote.note_answer(Answer::damaged, {.is_remote = true}, pace);
    CHECK(first.verdict == Verdict::retry);
    CHECK(first.retry_after == 5s);
    CHECK(verdict(remote, Answer::damaged, {.is_remote = true}) == Verdict::store);
}

TEST_CASE("an outage in the midst of a copy costs the copy none of its tries") {
    Attempts attempts;
    for (int i = 0; i < pace.retries; ++i) {
        CHECK(verdict(attempts, Answer::postponed) == Verdict::postpone);
        CHECK(attempts.note_answer(Answer::waiting, {}, pace).retry_after == 5s * (1 << i));
    }
    CHECK(verdict(attempts, Answer::waiting) == Verdict::give_up);
}
