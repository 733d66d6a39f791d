#include "analyzer/child/progress_rule.hpp"

#include <doctest/doctest.h>

using namespace vitrine::analyzer;
using namespace std::chrono_literals;
using Judgement = ProgressRule::Verdict;

namespace {

/// A child whose share of a processor and whose progress the test decides; looked at every second.
struct Child {
    Judgement after(std::chrono::seconds time, double share, bool gets_on = false) {
        for (std::chrono::seconds passed{0}; passed < time; passed += 1s) {
            processor += std::chrono::nanoseconds(static_cast<std::int64_t>(share * 1e9));
            if (gets_on) rule.note_progress();
            if (const Judgement verdict = rule.judge(1s, processor); verdict != Judgement::fine)
                return verdict;
        }
        return Judgement::fine;
    }

    ProgressRule rule{Patience{.computing = 120s, .idling = 120s}};
    std::chrono::nanoseconds processor{0};
};

}  // namespace

TEST_CASE("what gets on has no deadline, however little of the processor it has") {
    for (const double share : {2.0, 1.0, 0.05, 0.0}) {
        CAPTURE(share);
        CHECK(Child().after(1h, share, true) == Judgement::fine);
    }
}

TEST_CASE("a film whose reader has a twentieth of a core, in turns, is read to its end in an hour") {
    Child child;
    for (int turn = 0; turn < 180; ++turn) {
        CHECK(child.after(19s, 0) == Judgement::fine);
        CHECK(child.after(1s, 1, turn % 2 == 0) == Judgement::fine);
    }
}

TEST_CASE("without progress the child's own processor time counts, not the time that passes") {
    CHECK(Child().after(119s, 1) == Judgement::fine);
    CHECK(Child().after(121s, 1) == Judgement::computing);
    CHECK(Child().after(61s, 2) == Judgement::computing);
    CHECK(Child().after(2300s, 0.05) == Judgement::fine);
    CHECK(Child().after(2500s, 0.05) == Judgement::computing);
}

TEST_CASE("a child that neither computes nor gets on waits for something that does not come") {
    CHECK(Child().after(119s, 0) == Judgement::fine);
    CHECK(Child().after(120s, 0) == Judgement::idling);
    CHECK(Child().after(120s, 0.001) == Judgement::idling);  // threads that only wake and look
}

TEST_CASE("a child that others keep from the processors is not idle") {
    ProgressRule rule{Patience{.computing = 120s, .idling = 120s}};
    for (int second = 1; second <= 3600; ++second)
        REQUIRE(rule.judge(1s, 0s, second * 1s) == Judgement::fine);
}

TEST_CASE("progress begins the time anew") {
    Child child;
    CHECK(child.after(100s, 1) == Judgement::fine);
    CHECK(child.after(1s, 1, true) == Judgement::fine);
    CHECK(child.after(119s, 1) == Judgement::fine);
    CHECK(child.after(2s, 1) == Judgement::computing);
}
