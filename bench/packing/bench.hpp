#pragma once

#include "player/layout/pack/search_budget.hpp"
#include "player/layout/pack/shape.hpp"
#include "player/layout/plan/plan.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace vitrine::player {

using Items = std::vector<LayoutItem>;

/// Some items, drawn at random.
using Draw = std::function<Items(std::size_t count, Random& random)>;

inline constexpr Vec2 bench_canvas{1920, 1080};
inline constexpr double bench_ratio = bench_canvas.x / bench_canvas.y;

struct BenchOptions {
    std::string only;    // a table; empty: all
    int instances = 40;  // seeds a row
    std::int64_t edits = 1'000'000;
    std::string catalogue;  // its regions are the real ones; empty: none
};

/// CPU time of this process, so that other programs do not count. Everything measured runs in one thread.
double cpu_ms();

/// Hulls of 8 to 31 points, uniform in a square; areas log-uniform within a factor of 4.
Items random_hulls(std::size_t count, Random& random);

/// The items of all shots in a catalogue's records.
Items regions_of(const std::string& directory);

/// Draws some of the items, which are not empty. @param items  outlive the result
Draw drawn_from(const Items& items);

/// The shapes of items, scaled so that they would cover half the canvas.
struct ScaledItems {
    std::vector<Shape> shapes;
    std::vector<double> scales;
    double area = 0;  // sum over all, canvas px^2

    ScaledShapes view() const { return {shapes, scales}; }
};

ScaledItems scaled(const Items& items);

/// No limit of enlargement and nothing given up for filler: what is compared is density.
PlanRequest request_for(const Items& items, std::uint64_t seed);

/// @param fills  whether the layouts of default effort are finished as on a wall, with sizes of their own;
///               only where the items' frames are real
void print_shares(const char* title, const Draw& draw, int instances, bool fills);
void print_bands(const char* title, const Draw& draw, int instances, bool fills);

/// Turns of walls on two outputs.
void print_band_turns(const Draw& draw, int turns);
void print_paper(int instances);
void print_moves();
void print_many();
void print_changes(int instances);
void print_edits(std::int64_t count);

}  // namespace vitrine::player
