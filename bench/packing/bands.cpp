#include "player/layout/plan/bands.hpp"
#include "bench/packing/bench.hpp"
#include "player/layout/plan/plan_by_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

constexpr std::size_t max_tried = 4;  // items that are shared out in all ways

/// The sums over some walls.
struct BandSums {
    double with = 0;     // share of what the outputs show that is under I-Regions
    double without = 0;  // the same of the canvas without bands
    double most = 0;     // the same of the fullest of all ways to share the items out to the outputs
    double hidden = 0;   // canvas px^2 of I-Regions under bands
    double with_ms = 0;
    double without_ms = 0;
};

double hidden_px(const PlanRequest& request, const Layout& layout) {
    double hidden = 0;
    for (std::size_t i = 0; i < request.items.size(); ++i)
        for (const Box& band : request.canvas.bands)
            hidden += area(clipped(placed_region(request.items[i].item, layout.placements[i]), band));
    return hidden;
}

Canvas row_of(int count, double gap) {
    std::vector<Box> outputs;
    for (int k = 0; k < count; ++k) {
        const double left = k * (bench_canvas.x + gap);
        outputs.push_back({{left, 0}, {left + bench_canvas.x, bench_canvas.y}});
    }
    return canvas_of({count * (bench_canvas.x + gap) - gap, bench_canvas.y}, std::move(outputs));
}

/// I-Regions of one output that shows some of the items, canvas px^2.
double covered_on_output(const PlanRequest& request, unsigned items) {
    PlanRequest part = request;
    part.canvas = Canvas(bench_canvas);
    part.items.clear();
    for (std::size_t i = 0; i < request.items.size(); ++i)
        if ((items >> i & 1U) != 0) part.items.push_back(request.items[i]);
    return part.items.empty() ? 0 : covered_px(part, plan(part));
}

/// I-Regions of the fullest of all ways to share the items out to outputs of one size, canvas px^2.
double most_covered(const PlanRequest& request, std::size_t outputs) {
    const std::size_t count = request.items.size();
    std::vector<double> covered;
    for (unsigned items = 0; items < 1U << count; ++items)
        covered.push_back(covered_on_output(request, items));
    std::vector<double> most = covered;  // on some outputs, by the items that these show
    for (std::size_t k = 1; k < outputs; ++k) {
        const std::vector<double> before = most;
        for (unsigned items = 0; items < before.size(); ++items)
            for (unsigned last = 0; last <= items; ++last)
                if ((last & ~items) == 0)
                    most[items] = std::max(most[items], before[items ^ last] + covered[last]);
    }
    return most.back();
}

void add_wall(const Canvas& canvas, const PlanRequest& wished, BandSums& sums) {
    PlanRequest request = wished;
    request.canvas = Canvas(Vec2(canvas));
    const double start = cpu_ms();
    sums.without += covered_px(request, plan(request)) / (canvas.x * canvas.y);
    const double middle = cpu_ms();
    request.canvas = canvas;
    const Layout layout = plan(request);
    sums.with_ms += cpu_ms() - middle;
    sums.without_ms += middle - start;
    double shown = 0;
    for (const Box& output : canvas.outputs)
        shown += output.area();
    sums.with += covered_px(request, layout) / shown;
    sums.hidden += hidden_px(request, layout);
    if (request.items.size() <= max_tried) sums.most += most_covered(request, canvas.outputs.size()) / shown;
}

/// The sums over some turns.
struct TurnSums {
    double unseen = 0;
    double covered = 0;
    int moved = 0;      // items that stay and do not stand still
    int elsewhere = 0;  // those of them on an output on which nothing leaves
    double ms = 0;
};

void add_turn(const PlanRequest& request, const Seat& seat, const Layout& layout, TurnSums& sums) {
    const auto output_at = [&](Vec2 centre) { return output_of(request.canvas, Box{centre, centre}); };
    for (std::size_t i = 0; i < request.items.size(); ++i) {
        const auto& previous = request.items[i].previous;
        if (!previous || *previous == layout.placements[i]) continue;
        ++sums.moved;
        if (output_at(seat_of(request.items[i].item, *previous).centre) != output_at(seat.centre))
            ++sums.elsewhere;
    }
    sums.unseen += unseen_share(request, layout);
    sums.covered += covered_px(request, layout) / (2 * bench_canvas.x * bench_canvas.y);
}

/// One wall on two outputs, on which one item after the other takes the place of another.
TurnSums make_turns(const Draw& draw, std::size_t count, int turns) {
    Random random(count);
    PlanRequest request = request_for(draw(count, random), 1);
    request.fills = true;
    request.canvas = row_of(2, 40);
    Layout layout = plan(request);
    TurnSums sums;
    for (int turn = 0; turn < turns; ++turn) {
        const std::size_t leaving = uniform_index(random, count);
        const Seat seat = seat_of(request.items[leaving].item, layout.placements[leaving]);
        for (std::size_t i = 0; i < count; ++i) {
            request.items[i].previous = layout.placements[i];
            request.items[i].seat.reset();
        }
        request.items[leaving] = {.item = draw(1, random).front(), .seat = seat};
        const double start = cpu_ms();
        layout = plan(request);
        sums.ms += cpu_ms() - start;
        add_turn(request, seat, layout, sums);
    }
    return sums;
}

}  // namespace

void print_bands(const char* title, const Draw& draw, int instances, bool fills) {
    fmt::print("\nbezels, {}: share of the screens under regions, with bands and without, of {} walls\n",
               title, instances);
    fmt::print(
        "outputs  gap  items   with  without  quotient  most possible  px under bands   ms with  without\n");
    for (const auto& [outputs, gap] : {std::pair{2, 40.0}, {2, 200.0}, {3, 40.0}})
        for (const std::size_t count : {3, 4, 6, 12, 24}) {
            BandSums sums;
            for (int k = 0; k < instances; ++k) {
                Random random(static_cast<std::uint64_t>(k) + 1);
                PlanRequest wished = request_for(draw(count, random), static_cast<std::uint64_t>(k) + 1);
                wished.fills = fills;
                add_wall(row_of(outputs, gap), wished, sums);
            }
            const std::string most =
                count <= max_tried ? fmt::format("{:.3f}", sums.most / sums.without) : std::string("-");
            fmt::print(
                "{:>7}  {:>3}  {:>5}  {:.3f}    {:.3f}     {:.3f}  {:>13}  {:>14}  {:>8.0f}  {:>7.0f}\n",
                outputs, gap, count, sums.with / instances, sums.without / instances,
                sums.with / sums.without, most, sums.hidden, sums.with_ms / instances,
                sums.without_ms / instances);
        }
}

void print_band_turns(const Draw& draw, int turns) {
    fmt::print("\nbezels, {} turns of a wall on two outputs: mean of a turn\n", turns);
    fmt::print("items  no picture  regions  shots that move  of these on the other output     ms\n");
    for (const std::size_t count : {4, 6, 9, 12}) {
        const TurnSums sums = make_turns(draw, count, turns);
        fmt::print("{:>5}  {:>10.4f}  {:>7.3f}  {:>15.1f}  {:>28.1f}  {:>5.0f}\n", count, sums.unseen / turns,
                   sums.covered / turns, static_cast<double>(sums.moved) / turns,
                   static_cast<double>(sums.elsewhere) / turns, sums.ms / turns);
    }
}

}  // namespace vitrine::player
