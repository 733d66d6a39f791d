#include "player/playback/source_events.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("an event goes to who owns the source, and comes back where nobody listens") {
    SourceEvents events;
    std::vector<SourceId> heard;
    const auto listener = std::make_shared<const SourceListener>(
        SourceListener{.owner = 2, .call = [&](const SourceEvent& event) { heard.push_back(event.source); }});
    events.add(listener);

    const auto left =
        events.deliver({{.source = sources_of(2) + 5}, {.source = 5}, {.source = sources_of(3) - 1}});

    CHECK(heard == std::vector<SourceId>{sources_of(2) + 5, sources_of(3) - 1});
    REQUIRE(left.size() == 1);
    CHECK(left[0].source == 5);
}

TEST_CASE("who is gone is told nothing, and who comes after under the same number is") {
    SourceEvents events;
    int first = 0;
    int second = 0;
    auto gone = std::make_shared<const SourceListener>(
        SourceListener{.owner = 1, .call = [&](const SourceEvent&) { ++first; }});
    const auto next = std::make_shared<const SourceListener>(
        SourceListener{.owner = 1, .call = [&](const SourceEvent&) { ++second; }});
    events.add(gone);
    events.add(next);
    gone.reset();

    CHECK(events.deliver({{.source = sources_of(1) + 1}}).empty());

    CHECK(first == 0);
    CHECK(second == 1);
}
