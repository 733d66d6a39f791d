// Measures the cost of a frame of a film's tapestry with the processor drawing: at rest, dragged, and in each
// frame of a step from level to level, against one full-screen picture drawn in the same run. Tiles are
// noise.

#include "player/display/offscreen_screen.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/tapestry/tapestry_show.hpp"

#include <GLES3/gl3.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr Vec2 canvas{1280, 720};
constexpr auto frame_time = 16'666'667ns;

double cpu_milliseconds() {
    timespec spent{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &spent);
    return static_cast<double>(spent.tv_sec) * 1e3 + static_cast<double>(spent.tv_nsec) * 1e-6;
}

struct Cost {
    double mean = 0;  // CPU ms
    double most = 0;
};

Cost cost(int times, const std::function<void()>& work) {
    Cost cost;
    for (int k = 0; k < times; ++k) {
        const double before = cpu_milliseconds();
        work();
        glFinish();
        const double spent = cpu_milliseconds() - before;
        cost.mean += spent / times;
        cost.most = std::max(cost.most, spent);
    }
    return cost;
}

Tapestry two_hours() {
    Tapestry tapestry{.path = "film.mp4",
                      .duration = 2h,
                      .is_complete = true,
                      .folder = "tiles",
                      .height = 150,
                      .tile_width = 512,
                      .brick_width = 178,
                      .levels = {}};
    for (int count = 24; count <= 6144; count *= 2) {
        TapestryLevel level{.width = (count + 1) * 89, .keyframes = {}};
        for (int k = 0; k < count; ++k)
            level.keyframes.push_back(std::chrono::nanoseconds(2h) * (2 * k + 1) / (2 * count));
        level.has_zoom = !tapestry.levels.empty();
        tapestry.levels.push_back(std::move(level));
    }
    return tapestry;
}

/// The zoom mesh of a tile: each point goes to the place of its time on another level.
std::shared_ptr<const ZoomMesh> zoom(const Tapestry& tapestry, const TileId& tile, bool is_to_finer) {
    if (tile.level == 0 && !is_to_finer) return nullptr;
    const std::size_t other = is_to_finer ? tile.level + 1 : tile.level - 1;
    if (other >= tapestry.levels.size()) return nullptr;
    const int left = tile.tile * tapestry.tile_width;
    ZoomField field{.width = std::min(tapestry.tile_width, tapestry.levels[tile.level].width - left),
                    .height = tapestry.height,
                    .places = {},
                    .growths = {}};
    for (int row = 0; row < ZoomField::rows; ++row) {
        for (int column = 0; column < field.columns(); ++column) {
            const Vec2 point = field.point(column, row);
            field.places.push_back(
                {tapestry.x_at(other, tapestry.time_at(tile.level, left + point.x)), point.y});
            field.growths.push_back(is_to_finer ? 2 : 0.5);
        }
    }
    return std::make_shared<const ZoomMesh>(zoom_mesh(field, left, is_to_finer));
}

struct Noise {
    Noise(int wide, int high)
        : pixels(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high) * 4),
          sample{
              .width = wide, .height = high, .stride = static_cast<std::size_t>(wide) * 4, .pixels = pixels} {
        for (std::size_t i = 0; i < pixels.size(); ++i)
            pixels[i] = static_cast<std::byte>(i * 7 % 251);
    }

    std::vector<std::byte> pixels;
    Sample sample;
};

struct Bench {
    OffscreenScreen screen{{.width = 1280, .height = 720, .film = {}}};
    Renderer renderer{1280, 720};
    TapestryShow strip{two_hours(),
                       {.path = "film.mp4", .duration = 2h, .picture = {1280, 720}, .shots = {}},
                       canvas,
                       {.first_source = 1, .patience = {}}};
    Noise tile{512, 150};
    std::chrono::nanoseconds now = 0s;
    double scene = 0;  // CPU ms in all steps, without drawing

    void draw(const Frame& frame) {
        screen.begin_frame();
        renderer.draw(frame);
        glFinish();
    }

    void step() {
        const double before = cpu_milliseconds();
        TapestryStep step = strip.step(now);
        scene += cpu_milliseconds() - before;
        for (const TileId& id : step.missing) {
            renderer.upload(strip.sources().tile(id), tile.sample);
            strip.strips().add(strip.sources().generation, id,
                               {.to_coarser = zoom(strip.tapestry(), id, false),
                                .to_finer = zoom(strip.tapestry(), id, true)});
        }
        now += frame_time;
        draw(step.frame);
    }

    void run(std::chrono::nanoseconds duration) {
        for (const auto end = now + duration; now < end;)
            step();
    }

    void key(Key key) { strip.handle_gesture({.kind = Gesture::Kind::key, .key = key}); }
};

void print(const char* what, Cost spent, double one_picture) {
    fmt::print("{:<44} CPU {:6.2f} ms, worst {:6.2f} ms, {:5.2f} x one picture\n", what, spent.mean,
               spent.most, spent.mean / one_picture);
}

}  // namespace

int main() {
    Bench bench;
    bench.renderer.upload(bench.strip.sources().mark(), bench.tile.sample);
    const Noise film(1280, 720);
    bench.renderer.upload(2, film.sample);
    const Box all{{0, 0}, canvas};
    Cell cell{.parts = {to_polygon(all)}};
    cell.triangles = {{all.min, {all.max.x, 0}, all.max}, {all.min, all.max, {0, all.max.y}}};
    const Frame quad{
        .canvas = canvas,
        .items = {{.source = 2, .cell = std::make_shared<const Cell>(cell), .picture = {1278, 719}}}};
    bench.draw(quad);
    const double one = cost(60, [&] { bench.draw(quad); }).mean;
    print("one full-screen picture", {one, 0}, one);
    print("idle picture", cost(60, [&] { bench.draw({.canvas = canvas, .idle = 1}); }), one);

    bench.run(500ms);
    for (int k = 0; k < 4; ++k) {
        bench.key(Key::nearer);
        bench.run(1s);
    }
    print("strip at rest", cost(60, [&] { bench.step(); }), one);
    print("strip dragged",
          cost(60,
               [&] {
                   bench.strip.handle_gesture(
                       {.kind = Gesture::Kind::drag, .at = {600, 500}, .from = {640, 500}, .moved = {-9, 0}});
                   bench.step();
               }),
          one);
    for (const Key key : {Key::nearer, Key::farther}) {
        bench.run(2s);
        bench.key(key);
        bench.scene = 0;
        bench.step();  // the first frame still shows the level that it leaves
        print("first frame between two levels", cost(1, [&] { bench.step(); }), one);
        print(key == Key::nearer ? "step to a finer level, each of its others"
                                 : "step to a coarser level, each of its others",
              cost(36, [&] { bench.step(); }), one);
        fmt::print("{:<44} CPU {:6.2f} ms\n", "  of which without drawing", bench.scene / 36);
    }
    SourceId next = 1'000'000'000;
    print("upload of a tile", cost(30, [&] { bench.renderer.upload(next++, bench.tile.sample); }), one);
}
