#include "player/layout/pack/energy.hpp"

#include "player/layout/pack/descent.hpp"
#include "player/layout/pack/initial_packing.hpp"
#include "player/layout/pack/overlap.hpp"
#include "tests/player/layout/instances.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace vitrine;
using namespace vitrine::player;

namespace {

LayoutItem unit_square() {
    return {.region = to_polygon({{0, 0}, {1, 1}}), .core = {{0, 0}, {1, 1}}};
}

}  // namespace

TEST_CASE("the paper's energy of two squares side by side, worked by hand") {
    // Two squares of side 2 with a gap of 1: R_B is 5 x 2, E_es = 2 / 10, q_c = 2.5.
    const std::vector<LayoutItem> items{unit_square(), unit_square()};
    const std::vector<Placement> places{{2, {0, 0}}, {2, {3, 0}}};
    const Measure measure = measured(items, places);
    CHECK(measure.united == 8);
    CHECK(measure.hidden == 0);
    CHECK(measure.bounds == Box{{0, 0}, {5, 2}});
    // q_p = 2: alpha = 1 / (0.5^2 + 1e-6) = 3.999984; ln E = alpha ln 0.2 = -6.437726
    CHECK(paper_energy(measure, 2) == doctest::Approx(-6.437726).epsilon(1e-6));
    // q_p = 2.5: alpha = 1e6; E itself would underflow.
    CHECK(paper_energy(measure, 2.5) == doctest::Approx(1e6 * std::log(0.2)));
    // A screen of 2:1 that holds 5 x 2 is 5 x 2.5, one of 3:1 is 6 x 2.
    CHECK(screen_area(measure.bounds, 2) == doctest::Approx(12.5));
    CHECK(screen_area(measure.bounds, 3) == doctest::Approx(12));
}

TEST_CASE("the paper's energy of two squares that overlap, worked by hand") {
    // Two squares of side 2, one moved by (1, 1): union 7, E_occ = 1, R_B is 3 x 3, E_es = 2 / 9.
    const std::vector<LayoutItem> items{unit_square(), unit_square()};
    const std::vector<Placement> places{{2, {0, 0}}, {2, {1, 1}}};
    const Measure measure = measured(items, places);
    CHECK(measure.united == 7);
    CHECK(measure.hidden == 1);
    // q_p = 2: alpha = 1 / (1 + 1e-6); E = (2/9)^alpha + 1e5
    CHECK(std::exp(paper_energy(measure, 2)) == doctest::Approx(100000.2222225));
}

TEST_CASE("initial packing touches without overlap and descent never raises the energy") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        std::vector<Shape> shapes;
        for (const LayoutItem& item : items_of(random_request(6, seed)))
            shapes.push_back(shape_of(item.region));
        const std::vector<double> scales(shapes.size(), 0.1);
        Contacts contacts(shapes, 0);
        contacts.set_scales(scales);
        const auto packing = initial_packing({shapes, scales}, contacts, 1.5, PackingOrder::as_given);
        CHECK(packing[0] == Vec2{});
        const auto measure = [&](std::span<const Vec2> places) {
            std::vector<GridPolygon> outlines;
            for (std::size_t i = 0; i < shapes.size(); ++i)
                outlines.push_back(snapped(transformed(shapes[i].outline, scales[i], places[i])));
            const UnionArea areas(outlines);
            return Measure{areas.area(), areas.overlap(), areas.bounds()};
        };
        const Measure before = measure(packing);
        CHECK(before.hidden < 1e-3 * before.united);  // corners are rounded to 1/512 px
        Random random(seed);
        SearchBudget budget(1'000'000);
        const DescentResult end = descend({shapes, scales}, packing, 1.5, random, budget);
        const Measure after = measure(end.places);
        CHECK(end.steps > 0);
        CHECK(end.last_energy <= end.first_energy);
        CHECK(after.hidden <= before.hidden + 1e-9);
        CHECK(paper_energy(after, 1.5) < paper_energy(before, 1.5));
    }
}
