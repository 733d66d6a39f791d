#include "player/display/atomic_request.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

using namespace vitrine;
using namespace vitrine::player;

namespace {

Output output() {
    Output made{.connector = 50, .crtc = 40, .plane = 30};
    made.mode.hdisplay = 1920;
    made.mode.vdisplay = 1080;
    return made;
}

OutputProperties properties() {
    return {.connector = {{"CRTC_ID", 1}},
            .crtc = {{"MODE_ID", 2}, {"ACTIVE", 3}},
            .plane = {{"CRTC_ID", 4},
                      {"FB_ID", 5},
                      {"SRC_X", 6},
                      {"SRC_Y", 7},
                      {"SRC_W", 8},
                      {"SRC_H", 9},
                      {"CRTC_X", 10},
                      {"CRTC_Y", 11},
                      {"CRTC_W", 12},
                      {"CRTC_H", 13}}};
}

bool has(const AtomicRequest& request, const PropertyValue& wanted) {
    return std::ranges::find(request, wanted) != request.end();
}

}  // namespace

TEST_CASE("lighting a panel joins connector, CRTC, plane and picture in one request") {
    const AtomicRequest request = modeset_request(output(), properties(), 77, 88);

    CHECK(has(request, {50, 1, 40}));
    CHECK(has(request, {40, 2, 77}));
    CHECK(has(request, {40, 3, 1}));
    CHECK(has(request, {30, 4, 40}));
    CHECK(has(request, {30, 5, 88}));
    CHECK(has(request, {30, 8, 1920U << 16}));
    CHECK(has(request, {30, 9, 1080U << 16}));
    CHECK(has(request, {30, 12, 1920}));
    CHECK(has(request, {30, 13, 1080}));
}

TEST_CASE("turning a panel off ends its signal and keeps mode and picture for the next one") {
    CHECK(off_request(output(), properties()) == AtomicRequest{{40, 3, 0}});
}

TEST_CASE("a request names each property of an object once") {
    const AtomicRequest request = modeset_request(output(), properties(), 77, 88);

    std::set<std::pair<std::uint32_t, std::uint32_t>> named;
    for (const PropertyValue& change : request)
        named.emplace(change.object, change.property);

    CHECK(named.size() == request.size());
}

TEST_CASE("what is in the way of a panel goes in the same request") {
    const Obstacles in_the_way{.connectors = {51}, .crtcs = {41}, .planes = {31}};

    const AtomicRequest request = modeset_request(output(), properties(), 77, 88, in_the_way);

    CHECK(has(request, {51, 1, 0}));
    CHECK(has(request, {41, 2, 0}));
    CHECK(has(request, {41, 3, 0}));
    CHECK(has(request, {31, 4, 0}));
    CHECK(has(request, {31, 5, 0}));
    CHECK(has(request, {40, 3, 1}));
}

TEST_CASE("a link that may have gone bad is told to be good, where the card knows of links") {
    OutputProperties with_link = properties();
    with_link.connector["link-status"] = 14;

    CHECK(has(modeset_request(output(), with_link, 77, 88), {50, 14, 0}));
}

TEST_CASE("showing another picture changes nothing but the picture") {
    CHECK(flip_request(output(), properties(), 88) == AtomicRequest{{30, 5, 88}});
}

TEST_CASE("a card without a property that is needed is refused by its name") {
    OutputProperties lacking = properties();
    lacking.crtc.erase("ACTIVE");

    CHECK_THROWS_WITH_AS(modeset_request(output(), lacking, 77, 88), "the card has no property 'ACTIVE'",
                         std::runtime_error);
}
