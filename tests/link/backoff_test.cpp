#include "link/backoff.hpp"

#include <doctest/doctest.h>

using namespace vitrine::link;
using namespace std::chrono_literals;

TEST_CASE("pauses double up to the longest") {
    Backoff backoff;
    CHECK(backoff.next(0ms) == Backoff::first);
    CHECK(backoff.next(0ms) == 2 * Backoff::first);
    for (int k = 0; k < 20; ++k)
        backoff.next(0ms);
    CHECK(backoff.next(0ms) == Backoff::longest);
}

TEST_CASE("a connection that held begins anew, one that fell at once does not") {
    Backoff backoff;
    for (int k = 0; k < 5; ++k)
        backoff.next(0ms);
    CHECK(backoff.next(1s) > Backoff::first);
    CHECK(backoff.next(Backoff::held) == Backoff::first);
}
