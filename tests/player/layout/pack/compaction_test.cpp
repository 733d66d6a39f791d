#include "player/layout/pack/compaction.hpp"

#include "player/layout/pack/linear_program.hpp"
#include "player/layout/pack/optimizer.hpp"
#include "tests/player/layout/instances.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

namespace {

PackingProblem problem_of(std::span<const LayoutItem> items, Vec2 canvas) {
    PackingProblem problem;
    for (const LayoutItem& item : items) {
        problem.shapes.push_back(shape_of(item.region));
        problem.limits.push_back(100);
        problem.pinned.push_back(false);
        problem.pinned_places.emplace_back();
    }
    problem.scales = natural_scales(items, problem.shapes);
    problem.field = {{0, 0}, canvas};
    problem.clearance = 1;
    return problem;
}

}  // namespace

TEST_CASE("a linear program finds the corner of a square and the tip of a triangle") {
    LinearProgram square(2);  // |x| <= 3, |y| <= 2, x + y <= 4
    square.add_row(3)[0] = 1;
    square.add_row(3)[0] = -1;
    square.add_row(2)[1] = 1;
    square.add_row(2)[1] = -1;
    const std::span<double> sum = square.add_row(4);
    sum[0] = sum[1] = -1;
    CHECK(square.maximise(0, 100)[0] == doctest::Approx(3));

    LinearProgram tip(2);  // y <= 1 + x, y <= 5 - x, both rising to (2, 3)
    const std::span<double> rising = tip.add_row(1);
    rising[0] = 1;
    rising[1] = -1;
    const std::span<double> falling = tip.add_row(5);
    falling[0] = -1;
    falling[1] = -1;
    const std::vector<double> at = tip.maximise(1, 100);
    CHECK(at[0] == doctest::Approx(2));
    CHECK(at[1] == doctest::Approx(3));
}

TEST_CASE("a linear program without room stays where it is, and one without bound ends") {
    LinearProgram stuck(1);
    stuck.add_row(0)[0] = -1;
    stuck.add_row(0)[0] = -1;
    CHECK(stuck.maximise(0, 100)[0] == 0);
    LinearProgram boundless(1);
    boundless.add_row(1)[0] = 1;
    CHECK(boundless.maximise(0, 100)[0] == 0);
}

TEST_CASE("an item larger than the field is free nowhere") {
    const LayoutItem square{.region = to_polygon({{0, 0}, {10, 10}}), .core = {{0, 0}, {10, 10}}};
    const PackingProblem problem = problem_of(std::vector<LayoutItem>{square}, {200, 100});
    Contacts contacts(problem.shapes, problem.clearance);
    const double growth = 150 / (10 * problem.scales[0]);  // a side of 150 px
    for (const double y : {25.0, 50.0, 75.0})
        CHECK_FALSE(is_free(problem, {{{100, y}}, growth}, contacts));
    CHECK(is_free(problem, {{{100, 50}}, growth / 1.6}, contacts));
}

TEST_CASE("two squares in a box twice as wide as high grow until they fill it") {
    const LayoutItem square{.region = to_polygon({{0, 0}, {10, 10}}), .core = {{0, 0}, {10, 10}}};
    const std::vector<LayoutItem> items{square, square};
    PackingProblem problem = problem_of(items, {200, 100});
    problem.clearance = 0.5;
    Contacts contacts(problem.shapes, problem.clearance);
    SearchBudget budget(1'000'000);
    const double growth = 30 / (10 * problem.scales[0]);  // a side of 30 px
    const Arrangement packed = compacted(problem, {{{40, 30}, {120, 70}}, growth}, contacts, budget);
    CHECK(10 * problem.scale(0, packed.growth) == doctest::Approx(99.75).epsilon(1e-4));
    CHECK(is_free(problem, packed, contacts));
}

TEST_CASE("compacted arrangements are free and never smaller, pinned items stay, order holds") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const std::vector<LayoutItem> items = items_of(random_request(2 + seed % 9, seed));
        PackingProblem problem = problem_of(items, {1600, 900});
        problem.keeps_order = seed % 2 == 0;
        Random random(seed);
        Contacts contacts(problem.shapes, problem.clearance);
        Arrangement start;  // on a line, as large as they are free there
        for (std::size_t i = 0; i < items.size(); ++i)
            start.places.push_back(
                {1600.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(items.size()), 450});
        start.growth = max_free_growth(problem, start, contacts, 0, 1e9);
        REQUIRE(start.growth > 0);
        if (seed % 3 == 0) {
            problem.pinned[1] = true;
            problem.scales[1] *= start.growth;
            problem.pinned_places[1] = start.places[1];
        }
        SearchBudget budget(1'000'000);
        const Arrangement end = compacted(problem, start, contacts, budget);
        CHECK(end.growth >= start.growth);
        CHECK(is_free(problem, end, contacts));
        if (problem.pinned[1]) CHECK(length(end.places[1] - start.places[1]) < 1e-3);
    }
}
