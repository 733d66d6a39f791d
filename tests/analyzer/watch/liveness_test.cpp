#include "analyzer/watch/liveness.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;

namespace {

struct Bench {
    EventLoop loop;
    Liveness liveness{loop, [] { return StatusLine{}; }};
};

}  // namespace

TEST_CASE("nothing is overdue while what is expected happens in time, or not much later") {
    const Liveness::Time begin{1h};
    Bench bench;
    CHECK_FALSE(bench.liveness.overdue(begin + 100h));

    bench.liveness.expect("rescan of the media folder", begin + 10s);
    CHECK_FALSE(bench.liveness.overdue(begin + 10s + Liveness::patience));

    bench.liveness.expect("rescan of the media folder", begin + 20s);  // it was, and will be again
    CHECK_FALSE(bench.liveness.overdue(begin + 20s + Liveness::patience));
}

TEST_CASE("what does not happen is overdue, the longest first, though other things go on") {
    const Liveness::Time begin{1h};
    Bench bench;
    bench.liveness.expect("analysis of 'b'", begin + 20s);
    bench.liveness.expect("analysis of 'a'", begin + 10s);
    bench.liveness.expect("rescan of the media folder", begin + 3h);
    CHECK(bench.liveness.overdue(begin + 1h) == "analysis of 'a'");

    bench.liveness.meet("analysis of 'a'");
    CHECK(bench.liveness.overdue(begin + 1h) == "analysis of 'b'");

    bench.liveness.meet("analysis of 'b'");
    CHECK_FALSE(bench.liveness.overdue(begin + 1h));
}
