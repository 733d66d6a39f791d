#include "player/layout/plan/neighbours.hpp"

#include "tests/player/layout/instances.hpp"
#include "tests/player/layout/soundness.hpp"

#include <doctest/doctest.h>

#include <cstdint>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// A look of one colour, with a little chance in it.
ShotLook look_of(std::uint8_t shade, Random& random) {
    ShotLook look;
    for (std::uint8_t& colour : look.colours)
        colour = static_cast<std::uint8_t>(shade + random() % 10);
    return look;
}

/// Shots of three colours, mixed.
PlanRequest mixed_request(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    PlanRequest request = random_request(count, seed);
    request.neighbours = NeighbourChoice::alike;
    for (std::size_t i = 0; i < count; ++i)
        request.items[i].look = look_of(static_cast<std::uint8_t>(20 + 100 * (i % 3)), random);
    return request;
}

}  // namespace

TEST_CASE("neighbours are the regions whose parts of the canvas touch") {
    const auto box = [](double x) { return to_polygon({{x, 10}, {x + 20, 90}}); };
    const std::vector<Polygon> row{box(10), box(110), box(210)};
    CHECK(neighbours_of(row, {240, 100}) == Neighbours{{0, 1}, {1, 2}});
    CHECK(neighbours_of(std::span(row).first(1), {240, 100}).empty());
}

TEST_CASE("shots of one moment are more alike than their colours say") {
    using namespace std::chrono_literals;
    Random random(1);
    const std::chrono::sys_time<std::chrono::milliseconds> noon(10'000h);
    PlanItem a{.look = look_of(20, random), .taken = noon};
    PlanItem b{.look = look_of(120, random), .taken = noon + 100min};
    const double together = unlikeness(a, b);
    b.taken = noon + 3h;
    CHECK(unlikeness(a, b) == doctest::Approx(2 * together));
    CHECK(unlikeness(a, a) == 0);
    b.look.reset();
    CHECK(unlikeness(a, b) == doctest::Approx(0.4));
}

TEST_CASE("like shots stand beside each other, for at most 3 % of what I-Regions cover") {
    double before = 0, after = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        PlanRequest request = mixed_request(12, seed);
        const Layout alike = plan(request);
        CHECK(is_sound(items_of(request), alike, "alike"));
        request.neighbours = NeighbourChoice::any;
        const Layout any = plan(request);
        CHECK(1 - alike.energy >= 0.97 * (1 - any.energy));
        before += mean_unlikeness(request, any);
        after += mean_unlikeness(request, alike);
    }
    CHECK(after <= 0.8 * before);
}
