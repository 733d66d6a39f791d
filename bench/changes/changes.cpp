// Measures the changes of a wall: how often a shot has no free way, what the frames in between lack, how
// large newcomers are, and the time.
//   changes [CHANGES [FRAMES [CATALOGUE [COUNT...]]]]
// On items like those of real media, or on the shots of a catalogue. Each wall changes by turns, insertions,
// deletions and a drag in a row. Areas are exact, in px^2 of a canvas of 1920x1080: of I-Regions that stay
// and are covered, of canvas where nothing is opaque, and of filler that neither the old nor the new wall
// has; the largest of any frame. A shot that moves is seen twice where its I-Region is seen at its old or its
// new place, too. The last table is of drawn frames: the CPU time of all threads.

#include "player/display/offscreen_screen.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/crossfade.hpp"
#include "player/scene/transition.hpp"
#include "tests/player/layout/catalogue_items.hpp"
#include "tests/player/layout/fair_shares.hpp"
#include "tests/player/scene/changing_wall.hpp"
#include "tests/player/scene/frame_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr Vec2 canvas{1920, 1080};
constexpr int changes_a_wall = 10;
constexpr double max_scale = 1.5;     // of plans
constexpr double seen_twice = 0.001;  // share of the canvas: from there on one sees the second of a shot

double cpu_ms() {
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The value that a share of all values is below. @param values  not empty
double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

struct ChangeRow {
    int count = 0;
    int with_wayless = 0;  // changes in which a shot fades from place to place
    std::array<int, 5> kinds{};
    double search_ms = 0;
    double frame_ms = 0;
    int frames = 0;
    FrameFaults worst;
    int with_twins = 0;  // changes in which a shot that moves is seen twice
    double shortest_fade = 1;
};

/// The sizes of I-Regions in shares of their fair ones, and what they cover.
struct Sizes {
    std::vector<double> newcomers;
    std::vector<double> smallest;  // of each wall
    std::vector<double> covered;   // share of the canvas, of each wall
    std::vector<double> edges;     // share of the canvas' edge that no picture reaches, of each wall
    std::vector<double> moves;     // mean of the others' ways, shares of the diagonal, of each turn
    std::vector<double> on_way;    // smallest scale of a shot on its way, of each change
};

/// The shares of the canvas that no picture reaches in drags.
struct DragFigures {
    std::vector<double> held;     // in each frame, behind what is in hands
    std::vector<double> dropped;  // after each drop
    std::vector<double> edges;    // after each drop: share of the canvas' edge
    int ways = 0;
    int with_wayless = 0;  // ways on which a shot fades from place to place
};

double filler_share(const std::vector<PlacedShot>& wall) {
    double sum = 0;
    for (const PlacedShot& placed : wall)
        for (const Polygon& polygon : placed.cell->filler)
            sum += signed_area(polygon);
    return sum / (canvas.x * canvas.y);
}

/// The share of the canvas' edge that no picture reaches.
double dark_edge_share(const std::vector<PlacedShot>& wall) {
    constexpr double inset = 0.5;  // px
    constexpr int points = 240;    // a side
    const Vec2 inner = canvas - Vec2{2 * inset, 2 * inset};
    int dark = 0;
    const auto look_at = [&](double x, double y) {
        const Vec2 point = Vec2{inset, inset} + Vec2{inner.x * x, inner.y * y};
        const bool is_framed = std::ranges::any_of(wall, [&](const PlacedShot& placed) {
            const Vec2 p = (point - placed.placement.offset) * (1 / placed.placement.scale);
            const Box& core = placed.shot.item.core;
            return p.x >= core.min.x && p.x <= core.max.x && p.y >= core.min.y && p.y <= core.max.y;
        });
        if (!is_framed) ++dark;
    };
    for (int k = 0; k < points; ++k) {
        const double at = (k + 0.5) / points;
        look_at(at, 0), look_at(at, 1), look_at(0, at), look_at(1, at);
    }
    return dark / (4.0 * points);
}

/// Notes the frames of a drag by some hands. The wall after it becomes the shown one.
void look_at_drag(DragFigures& figures, ChangingWall& wall, int hands) {
    const WallWay* last = nullptr;
    wall.drag(hands, [&](const TouchedHouse& house, const Frame& frame) {
        double filler = 0;
        for (std::size_t i = 0; i < house.wall.size(); ++i)
            for (const Polygon& outline : frame.items[i].cell->filler)
                if (frame.items[i].alpha >= 1) filler += signed_area(outline);
        figures.held.push_back(filler / (canvas.x * canvas.y));
        const WallWay* way = house.change ? house.change->way.get() : nullptr;
        if (way != nullptr && way != last) {
            ++figures.ways;
            if (way->wayless > 0) ++figures.with_wayless;
        }
        last = way;
    });
    figures.dropped.push_back(filler_share(wall.shown()));
    figures.edges.push_back(dark_edge_share(wall.shown()));
}

void add_sizes(Sizes& sizes, const std::vector<PlacedShot>& before, const std::vector<PlacedShot>& after) {
    std::vector<LayoutItem> items;
    std::vector<Placement> placements;
    for (const PlacedShot& placed : after) {
        items.push_back(placed.shot.item);
        placements.push_back(placed.placement);
    }
    const std::vector<double> shares = fair_shares(items, placements, max_scale);
    sizes.smallest.push_back(std::ranges::min(shares));
    double covered = 0;
    double moved = 0;
    double others = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const Seat seat = seat_of(items[i], placements[i]);
        covered += seat.area / (canvas.x * canvas.y);
        const PlacedShot* same = find_source(before, after[i].shot.source);
        if (same == nullptr) {
            sizes.newcomers.push_back(shares[i]);
            continue;
        }
        moved += length(seat.centre - seat_of(items[i], same->placement).centre) / length(canvas);
        ++others;
    }
    sizes.covered.push_back(covered);
    if (others > 0) sizes.moves.push_back(moved / others);
}

void look_at(ChangeRow& row, const Transition& made, int frames) {
    ++row.count;
    ++row.kinds.at(static_cast<std::size_t>(made.motion.kind));
    if (wayless_count(made) > 0) ++row.with_wayless;
    row.shortest_fade = std::min(row.shortest_fade, made.fade_end - made.fade_begin);
    double twice = 0;
    for (int k = 0; k <= frames; ++k) {
        const double share = k / static_cast<double>(frames);
        const double before = cpu_ms();
        const auto passed = std::chrono::duration_cast<std::chrono::nanoseconds>(made.duration * share);
        (void)transition_frame(made, passed, {}, {});
        row.frame_ms += cpu_ms() - before;
        ++row.frames;
        const FrameFaults faults = faults_of(made, share);
        row.worst.covered = std::max(row.worst.covered, faults.covered);
        row.worst.bare = std::max(row.worst.bare, faults.bare);
        row.worst.dark = std::max(row.worst.dark, faults.dark);
        twice = std::max(twice, faults.twice);
    }
    if (twice > seen_twice * canvas.x * canvas.y) ++row.with_twins;
}

/// The changes of walls of one size.
class ChangedWalls {
  public:
    ChangedWalls(std::size_t count, int frames) : count_(count), frames_(frames) {}

    void run(std::uint64_t seed, const DrawItems& draw) {
        ChangingWall wall(canvas, count_, seed, draw);
        for (int k = 0; k < changes_a_wall - 1; ++k) {
            const bool is_turn = k % 5 < 3;
            auto next = is_turn ? wall.turned() : k % 5 == 3 ? wall.with_one_more() : wall.with_one_less();
            add(is_turn ? "turn" : k % 5 == 3 ? "insertion" : "deletion", wall, next, {});
            add_sizes(sizes_, wall.shown(), next);
            sizes_.edges.push_back(dark_edge_share(next));
            wall.show(std::move(next));
        }
        for (const int hands : {1, 2})
            look_at_drag(drags_.at(static_cast<std::size_t>(hands - 1)), wall, hands);
    }

    void print() const {
        for (const auto& [name, row] : rows_)
            fmt::print("| {} | {} | {} | {:.1f} | {} | {:.2f} | {:.2f} | {:.2f} | {:.3f} | {:.3f} | {:.3f} | "
                       "{:.1f} |\n",
                       count_, name, row.count, 100.0 * row.with_wayless / row.count,
                       fmt::join(row.kinds, " "), row.shortest_fade, row.search_ms / row.count,
                       row.frame_ms / row.frames, row.worst.covered, row.worst.bare, row.worst.dark,
                       100.0 * row.with_twins / row.count);
        const auto print_shares = [](const char* name, const std::vector<double>& values) {
            fmt::print("{}: least {:.2f}, 5th percentile {:.2f}, median {:.2f}\n", name, quantile(values, 0),
                       quantile(values, 0.05), quantile(values, 0.5));
        };
        print_shares("I-Region of a newcomer / its fair share", sizes_.newcomers);
        print_shares("smallest I-Region of a wall / its fair share", sizes_.smallest);
        print_shares("share of the canvas that I-Regions cover", sizes_.covered);
        print_shares("smallest scale of a shot on its way / at rest", sizes_.on_way);
        fmt::print("mean way of the others: median {:.3f} of the diagonal\n", quantile(sizes_.moves, 0.5));
        const auto print_most = [](const char* name, const std::vector<double>& values) {
            fmt::print("{}: median {:.3f}, 95th percentile {:.3f}, most {:.3f}\n", name,
                       quantile(values, 0.5), quantile(values, 0.95), quantile(values, 1));
        };
        print_most("no picture at the edge after another change", sizes_.edges);
        for (std::size_t k = 0; k < drags_.size(); ++k) {
            const DragFigures& figures = drags_.at(k);
            fmt::print("drags by {} hands: {} ways, {} on which a shot fades from place to place\n", k + 1,
                       figures.ways, figures.with_wayless);
            print_most("no picture behind the hands", figures.held);
            print_most("no picture after a drop", figures.dropped);
            print_most("no picture at the edge after a drop", figures.edges);
        }
        std::fflush(stdout);
    }

  private:
    void add(const std::string& name, const ChangingWall& wall, const std::vector<PlacedShot>& next,
             const TransitionStyle& style) {
        const double start = cpu_ms();
        const Transition made = transition(canvas, wall.shown(), next, style);
        rows_[name].search_ms += cpu_ms() - start;
        sizes_.on_way.push_back(smallest_scale(made.motion));
        look_at(rows_[name], made, frames_);
    }

    std::size_t count_;
    int frames_;
    std::map<std::string, ChangeRow> rows_;
    Sizes sizes_;
    std::array<DragFigures, 2> drags_;  // by one hand and by two
};

/// Prints the CPU time of frames during changes and between them. All shots are films of 640 x 360.
void print_drawing(int changes, const DrawItems& draw) {
    constexpr std::size_t count = 12;
    constexpr int frames = 24;  // of each change, and after it
    OffscreenScreen screen({.width = static_cast<int>(canvas.x), .height = static_cast<int>(canvas.y)});
    Renderer renderer(static_cast<int>(canvas.x), static_cast<int>(canvas.y));
    std::vector<std::byte> pixels(std::size_t{640} * 360 * 4, std::byte{90});
    Sample sample{.width = 640, .height = 360, .stride = std::size_t{640} * 4};
    sample.pixels = pixels;
    const auto upload = [&](const std::vector<PlacedShot>& wall) {
        for (const PlacedShot& placed : wall)
            for (int k = 0; k < 2 && !renderer.has(placed.shot.source); ++k)
                renderer.upload(placed.shot.source, sample);
    };
    const auto cost = [&](const std::function<Frame()>& made) {
        const double before = cpu_ms();
        screen.begin_frame();
        renderer.draw(made());
        screen.present({});
        return cpu_ms() - before;
    };
    ChangingWall wall(canvas, count, 1, draw);
    std::vector<double> during;
    std::vector<double> between;
    for (int change = 0; change < changes; ++change) {
        auto next = wall.turned();
        const Transition made = transition(canvas, wall.shown(), next, {});
        upload(wall.shown());
        upload(next);
        for (int k = 1; k < frames; ++k)
            during.push_back(
                cost([&] { return transition_frame(made, made.duration * k / frames, {}, {}); }));
        wall.show(std::move(next));
        for (int k = 1; k < frames; ++k)
            between.push_back(cost([&] { return standing_frame(canvas, wall.shown(), {}); }));
    }
    const double median = quantile(during, 0.5) / quantile(between, 0.5);
    const double late = quantile(during, 0.99) / quantile(between, 0.99);
    fmt::print("CPU of a drawn frame, {} shots, median / p99: between changes {:.1f} / {:.1f} ms, during one "
               "{:.1f} / {:.1f} ms: {:.2f} / {:.2f} times\n",
               count, quantile(between, 0.5), quantile(between, 0.99), quantile(during, 0.5),
               quantile(during, 0.99), median, late);
}

}  // namespace

int main(int argc, char** argv) {
    const int changes = argc > 1 ? std::atoi(argv[1]) : 60;
    const int frames = argc > 2 ? std::atoi(argv[2]) : 20;
    const std::vector<LayoutItem> real =
        argc > 3 && *argv[3] != '\0' ? items_of_catalogue(argv[3]) : std::vector<LayoutItem>{};
    const DrawItems draw = [&](Random& random) {
        return real.empty() ? random_item(random) : real[uniform_index(random, real.size())];
    };
    fmt::print("| n | change | count | no free way % | still straight staged shrunk detour | shortest fade | "
               "search ms | frame ms | covered px^2 | bare | new filler | seen twice % "
               "|\n|--|--|--|--|--|--|--|--|--|--|--|--|\n");
    std::vector<std::size_t> counts{6, 12, 24};  // shots a wall
    if (argc > 4) counts.clear();
    for (int i = 4; i < argc; ++i)
        counts.push_back(static_cast<std::size_t>(std::atoi(argv[i])));
    for (const std::size_t count : counts) {
        ChangedWalls walls(count, frames);
        for (int done = 0; done < changes; done += changes_a_wall)
            walls.run(static_cast<std::uint64_t>(done) + 1, draw);
        walls.print();
    }
    print_drawing(std::max(1, changes / changes_a_wall), draw);
}
