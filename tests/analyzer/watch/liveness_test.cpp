#include "analyzer/watch/liveness.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;

TEST_CASE("all is well while what is expected comes in time, or not much later") {
    const Pulse::Time begin{1h};
    Pulse pulse;
    CHECK_FALSE(pulse.missed(begin + 100h));

    pulse.expect("the folder is read", begin + 10s);
    CHECK_FALSE(pulse.missed(begin + 10s + Pulse::patience));

    pulse.expect("the folder is read", begin + 20s);  // it was, and will be again
    CHECK_FALSE(pulse.missed(begin + 20s + Pulse::patience));
}

TEST_CASE("what does not come is missed, the longest first, though other things go on") {
    const Pulse::Time begin{1h};
    Pulse pulse;
    pulse.expect("the child of 'b' ends", begin + 20s);
    pulse.expect("the child of 'a' ends", begin + 10s);
    pulse.expect("the folder is read", begin + 3h);
    CHECK(pulse.missed(begin + 1h) == "the child of 'a' ends");

    pulse.came("the child of 'a' ends");
    CHECK(pulse.missed(begin + 1h) == "the child of 'b' ends");

    pulse.came("the child of 'b' ends");
    CHECK_FALSE(pulse.missed(begin + 1h));
}
