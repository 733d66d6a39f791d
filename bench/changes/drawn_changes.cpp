// Counts the faults of changes on frames as the renderer draws them.
//   drawn_changes [CHANGES [FRAMES [CATALOGUE [COUNT [FIRST_SEED]]]]]
// On items like those of real media, or on the shots of a catalogue. Each wall has eleven changes: turns,
// insertions, deletions, a drag by one hand and one by two, as the player makes them. Each shot has one
// bright colour of its own. A pixel of an I-Region that stays is covered where it has another colour. A pixel
// is dark where it is darker than any picture though neither the old nor the new wall has filler there.
// Printed are the changes, the frames, and the most pixels of any frame.

#include "player/scene/transition_frame.hpp"
#include "tests/player/layout/catalogue_items.hpp"
#include "tests/player/render/drawn_wall.hpp"
#include "tests/player/scene/changing_wall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr int width = 480;  // px
constexpr int height = 270;
constexpr int changes_a_wall = 11;  // two of them drags
constexpr int levels = 5;           // of a channel
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

bool is_at_one(const std::vector<Polygon>& outlines, Vec2 point) {
    return std::ranges::any_of(outlines, [&](const Polygon& outline) { return is_at(outline, point); });
}

std::vector<Polygon> filler_of(const std::vector<PlacedShot>& wall) {
    std::vector<Polygon> all;
    for (const PlacedShot& placed : wall)
        all.insert(all.end(), placed.cell->filler.begin(), placed.cell->filler.end());
    return all;
}

struct Faults {
    int covered = 0;  // px
    int dark = 0;
};

int covered_pixels(const Picture& picture, const WallShot& shot, const Placement& placement) {
    const Polygon region = placed_region(shot.item, placement);
    const Box box = intersection(bounding_box(region), {{0, 0}, {width, height}});
    const Colour own = colour_of(shot.source);
    int count = 0;
    for (int y = static_cast<int>(box.min.y); y < static_cast<int>(box.max.y); ++y)
        for (int x = static_cast<int>(box.min.x); x < static_cast<int>(box.max.x); ++x)
            if (!is_near(at(picture, x, y), own, 4) && is_deep_in(region, {x + 0.5, y + 0.5})) ++count;
    return count;
}

/// The pixels that are darker than any picture where no wall has filler.
int dark_pixels(const Picture& picture, const std::function<bool(Vec2)>& is_filler) {
    int count = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (std::ranges::min(at(picture, x, y)) < darkest - level_step && !is_filler({x + 0.5, y + 0.5}))
                ++count;
    return count;
}

std::vector<PlacedShot> placed_shots(const std::vector<ChangingShot>& wall) {
    std::vector<PlacedShot> all;
    for (const ChangingShot& shot : wall)
        all.push_back(shot.placed);
    return all;
}

Faults faults_of(DrawnWall& drawn, const Transition& made, double share) {
    const auto passed = std::chrono::duration_cast<std::chrono::nanoseconds>(made.duration * share);
    drawn.frame = transition_frame(made, passed, {}, 0s);
    const Picture picture = drawn.shown();
    const std::vector<Placement> placements = placements_at(made, share);
    Faults faults;
    for (const ChangingShot& shot : made.old_wall)
        if (shot.moving)
            faults.covered += covered_pixels(picture, shot.placed.shot, placements[*shot.moving]);
    std::vector<Polygon> filler = filler_of(placed_shots(made.old_wall));
    for (const Polygon& more : filler_of(placed_shots(made.new_wall)))
        filler.push_back(more);
    faults.dark = dark_pixels(picture, [&](Vec2 point) { return is_at_one(filler, point); });
    return faults;
}

/// The faults of a frame of a wall that is touched. What is in a hand may cover others.
/// @param filler  of the wall before the touch
Faults faults_of(DrawnWall& drawn, const TouchedHouse& house, const Frame& frame,
                 const std::vector<Polygon>& filler) {
    drawn.frame = frame;
    const auto dark = dark_pixels(drawn.shown(), [&](Vec2 point) {
        return is_at_one(filler, point) || is_at_one(filler_of(house.wall), point);
    });
    drawn.frame.items.resize(house.wall.size());
    const Picture picture = drawn.shown();
    double light = 0;
    for (const DrawItem& item : drawn.frame.items)
        light = std::max(light, item.alpha);
    Faults faults{.dark = dark};
    for (const DrawItem& item : drawn.frame.items)
        if (item.alpha >= light)
            faults.covered +=
                covered_pixels(picture, find_source(house.wall, item.source)->shot, item.placement);
    return faults;
}

Faults larger(const Faults& a, const Faults& b) {
    return {std::max(a.covered, b.covered), std::max(a.dark, b.dark)};
}

struct Row {
    int changes = 0;
    int frames = 0;
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
        for (int k = 0; k < changes_a_wall - 2; ++k) {
            const bool is_turn = k % 5 < 3;
            auto next = is_turn ? wall.turned() : k % 5 == 3 ? wall.with_one_more() : wall.with_one_less();
            add(is_turn      ? "turn"
                : k % 5 == 3 ? "insertion"
                             : "deletion",
                transition(wall.canvas(), wall.shown(), next, {}), seed);
            wall.show(std::move(next));
        }
        for (const int hands : {1, 2}) {
            Faults worst;
            int frames = 0;
            const std::vector<Polygon> filler = filler_of(wall.shown());
            wall.drag(hands, [&](const TouchedHouse& house, const Frame& frame) {
                worst = larger(worst, faults_of(drawn_, house, frame, filler));
                ++frames;
            });
            note(hands == 1 ? "drag by one hand" : "drag by two hands", worst, frames, seed);
        }
    }

    void print(std::size_t count) {
        for (const auto& [name, row] : rows_)
            fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", count, name, row.changes, row.frames,
                       row.faulty, row.worst.covered, row.worst.dark);
        std::fflush(stdout);
        rows_.clear();
    }

  private:
    void add(const std::string& name, const Transition& made, std::uint64_t seed) {
        Faults worst;
        for (int k = 0; k <= frames_; ++k)
            worst = larger(worst, faults_of(drawn_, made, k / static_cast<double>(frames_)));
        note(name, worst, frames_ + 1, seed);
    }

    void note(const std::string& name, const Faults& worst, int frames, std::uint64_t seed) {
        Row& row = rows_[name];
        ++row.changes;
        row.frames += frames;
        row.worst = larger(row.worst, worst);
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
    if (argc > 4) counts = {static_cast<std::size_t>(std::atoi(argv[4]))};
    const std::uint64_t first = argc > 5 ? std::strtoull(argv[5], nullptr, 10) : 1;
    fmt::print(
        "| n | change | count | frames | with a fault | covered px | dark px |\n|--|--|--|--|--|--|--|\n");
    DrawnChanges drawn(frames);
    for (const std::size_t count : counts) {
        for (int wall = 0; wall * changes_a_wall < changes; ++wall)
            drawn.run(count, first + static_cast<std::uint64_t>(wall), draw);
        drawn.print(count);
    }
}
