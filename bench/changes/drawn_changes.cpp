// Counts the faults of changes on frames as the renderer draws them.
//   drawn_changes [CHANGES [FRAMES [CATALOGUE [COUNT...]]]]
// On items like those of real media, or on the shots of a catalogue. Each shot has one bright colour of its
// own. A pixel of an I-Region that stays is covered where it has another colour. A pixel is dark where it is
// darker than any picture though neither the old nor the new wall has filler there. Printed are the changes,
// the frames, and the most pixels of any frame.

#include "player/scene/transition_frame.hpp"
#include "tests/player/layout/catalogue_items.hpp"
#include "tests/player/render/drawn_wall.hpp"
#include "tests/player/scene/changing_wall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr int width = 480;  // px
constexpr int height = 270;
constexpr int changes_a_wall = 10;
constexpr int levels = 5;  // of a channel
constexpr int darkest = 150;
constexpr int level_step = 25;
constexpr SourceId max_sources = 100;
constexpr double inset = 1.5;  // px; borders are as wide as a pixel, and lie on whole regions' edges

Colour colour_of(SourceId source) {
    const int code = static_cast<int>(source * 7 % (levels * levels * levels));
    return {darkest + level_step * (code % levels), darkest + level_step * (code / levels % levels),
            darkest + level_step * (code / (levels * levels))};
}

/// True if a point lies so deep in a convex outline.
bool is_deep_in(const Polygon& outline, Vec2 point) {
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 side = outline[(k + 1) % outline.size()] - outline[k];
        if (length(side) > 0 && cross(side, point - outline[k]) < inset * length(side)) return false;
    }
    return true;
}

/// True if a point lies in an outline of any shape.
bool is_in(const Polygon& outline, Vec2 point) {
    bool is_inside = false;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 a = outline[k], b = outline[(k + 1) % outline.size()];
        if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y))
            is_inside = !is_inside;
    }
    return is_inside;
}

/// True if a point lies in an outline, or so near to it that the border of filler reaches it.
bool is_at(const Polygon& outline, Vec2 point) {
    if (is_in(outline, point)) return true;
    for (std::size_t k = 0; k < outline.size(); ++k)
        if (distance_to_segment(point, outline[k], outline[(k + 1) % outline.size()]) <= inset) return true;
    return false;
}

/// True if a point lies in filler of one of the two walls, or at its edge.
bool is_at_filler(const Transition& made, Vec2 point) {
    for (const auto* wall : {&made.old_wall, &made.new_wall})
        for (const ChangingShot& shot : *wall)
            for (const Polygon& filler : shot.placed.cell->filler)
                if (is_at(filler, point)) return true;
    return false;
}

struct Faults {
    int covered = 0;  // px
    int dark = 0;
};

int covered_pixels(const Picture& picture, const ChangingShot& shot, const Placement& at_time) {
    const Polygon region = placed_region(shot.placed.shot.item, at_time);
    const Box box = intersection(bounding_box(region), {{0, 0}, {width, height}});
    const Colour own = colour_of(shot.placed.shot.source);
    int count = 0;
    for (int y = static_cast<int>(box.min.y); y < static_cast<int>(box.max.y); ++y)
        for (int x = static_cast<int>(box.min.x); x < static_cast<int>(box.max.x); ++x)
            if (!is_near(at(picture, x, y), own, 4) && is_deep_in(region, {x + 0.5, y + 0.5})) ++count;
    return count;
}

Faults faults_of(DrawnWall& drawn, const Transition& made, double share) {
    const auto passed = std::chrono::duration_cast<std::chrono::nanoseconds>(made.duration * share);
    drawn.frame = transition_frame(made, passed, {}, 0s);
    const Picture picture = drawn.shown();
    const std::vector<Placement> placements = placements_at(made, share);
    Faults faults;
    for (const ChangingShot& shot : made.old_wall)
        if (shot.moving) faults.covered += covered_pixels(picture, shot, placements[*shot.moving]);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Colour colour = at(picture, x, y);
            if (std::ranges::min(colour) < darkest - level_step && !is_at_filler(made, {x + 0.5, y + 0.5}))
                ++faults.dark;
        }
    return faults;
}

struct Row {
    int changes = 0;
    int faulty = 0;  // changes
    Faults worst;
};

/// Draws the changes of a wall, and notes their faults by the kind of change.
class DrawnChanges {
  public:
    explicit DrawnChanges(int frames) : frames_(frames) {
        for (SourceId source = 1; source <= max_sources; ++source)
            drawn_.renderer.upload(source, plain(colour_of(source)).sample);
    }

    void run(std::size_t count, std::uint64_t seed, const DrawItems& draw) {
        ChangingWall wall({width, height}, count, seed, draw);
        for (int k = 0; k < changes_a_wall - 1; ++k) {
            const bool is_turn = k % 5 < 3;
            auto next = is_turn ? wall.turned() : k % 5 == 3 ? wall.with_one_more() : wall.with_one_less();
            add(is_turn      ? "turn"
                : k % 5 == 3 ? "insertion"
                             : "deletion",
                transition(wall.canvas(), wall.shown(), next, {}), seed);
            wall.show(std::move(next));
        }
        const TransitionStyle follows{.duration = 120ms};
        wall.drag([&](const std::vector<PlacedShot>& next) {
            add("drag, a step", transition(wall.canvas(), wall.shown(), next, follows), seed);
        });
    }

    void print(std::size_t count) {
        for (const auto& [name, row] : rows_)
            fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", count, name, row.changes,
                       row.changes * (frames_ + 1), row.faulty, row.worst.covered, row.worst.dark);
        std::fflush(stdout);
        rows_.clear();
    }

  private:
    void add(const std::string& name, const Transition& made, std::uint64_t seed) {
        Row& row = rows_[name];
        Faults worst;
        for (int k = 0; k <= frames_; ++k) {
            const Faults faults = faults_of(drawn_, made, k / static_cast<double>(frames_));
            worst = {std::max(worst.covered, faults.covered), std::max(worst.dark, faults.dark)};
        }
        ++row.changes;
        row.worst = {std::max(row.worst.covered, worst.covered), std::max(row.worst.dark, worst.dark)};
        if (worst.covered + worst.dark == 0) return;
        ++row.faulty;
        fmt::print(stderr, "{} {} of seed {}: {} px covered, {} px dark\n", name, row.changes, seed,
                   worst.covered, worst.dark);
    }

    int frames_;
    DrawnWall drawn_{width, height};
    std::map<std::string, Row> rows_;
};

}  // namespace

int main(int argc, char** argv) {
    const int changes = argc > 1 ? std::atoi(argv[1]) : 60;
    const int frames = argc > 2 ? std::atoi(argv[2]) : 10;
    const std::vector<LayoutItem> real =
        argc > 3 && *argv[3] != '\0' ? items_of_catalogue(argv[3]) : std::vector<LayoutItem>{};
    const DrawItems draw = [&](Random& random) {
        return real.empty() ? random_item(random) : real[uniform_index(random, real.size())];
    };
    std::vector<std::size_t> counts{6, 12, 24};  // shots a wall
    if (argc > 4) counts.clear();
    for (int i = 4; i < argc; ++i)
        counts.push_back(static_cast<std::size_t>(std::atoi(argv[i])));
    fmt::print(
        "| n | change | count | frames | with a fault | covered px | dark px |\n|--|--|--|--|--|--|--|\n");
    DrawnChanges drawn(frames);
    for (const std::size_t count : counts) {
        for (int done = 0; done < changes; done += changes_a_wall)
            drawn.run(count, static_cast<std::uint64_t>(done) + 1, draw);
        drawn.print(count);
    }
}
