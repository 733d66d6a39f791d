#include "player/render/uncovered.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("what boxes leave of an area is each place of it that is in no box, once") {
    std::mt19937 random(3);
    const auto any = [&](int from, int to) {
        return from + static_cast<int>(random() % static_cast<unsigned>(to - from));
    };
    const auto is_in = [](const Box& box, int x, int y) {
        return x + 0.5 > box.min.x && x + 0.5 < box.max.x && y + 0.5 > box.min.y && y + 0.5 < box.max.y;
    };
    const Box area{{0, 0}, {16, 9}};
    for (int round = 0; round < 50; ++round) {
        std::vector<Box> boxes;
        for (int k = any(0, 4); k > 0; --k) {
            const Vec2 corner{static_cast<double>(any(-3, 16)), static_cast<double>(any(-3, 9))};
            boxes.push_back(
                {corner, corner + Vec2{static_cast<double>(any(0, 20)), static_cast<double>(any(0, 12))}});
        }
        const std::vector<Box> rest = uncovered(area, boxes);
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 16; ++x) {
                const bool is_covered =
                    std::ranges::any_of(boxes, [&](const Box& box) { return is_in(box, x, y); });
                REQUIRE(std::ranges::count_if(rest, [&](const Box& box) { return is_in(box, x, y); }) ==
                        (is_covered ? 0 : 1));
            }
    }
}
