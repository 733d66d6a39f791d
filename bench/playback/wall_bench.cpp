// Plays films side by side on a wall of equal cells for some seconds in real time, as the player does, so
// that peers.py can compare what that costs with what other programs need for the same picture.
//
//     wall_bench draw|upload COLUMNS ROWS SECONDS FILE...
//
// The cells take the files in turn. `upload` leaves out the drawing: with a graphics card that is not the
// processor's work.

#include "player/display/gl_device.hpp"
#include "player/display/offscreen_screen.hpp"
#include "player/playback/source_pool.hpp"
#include "player/render/renderer.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr int width = 1280;  // px
constexpr int height = 720;
constexpr int rate = 30;  // pictures a second
constexpr auto shot = 5s;

struct Job {
    bool draws = true;
    int columns = 1;
    int rows = 1;
    int seconds = 1;
    std::vector<std::string> files;
};

std::shared_ptr<const Cell> cell(double left, double top, double across, double down) {
    const Vec2 a{left, top};
    const Vec2 b{left + across, top};
    const Vec2 c{left + across, top + down};
    const Vec2 d{left, top + down};
    return std::make_shared<const Cell>(Cell{.parts = {{a, b, c, d}}, .triangles = {{a, b, c}, {a, c, d}}});
}

/// Starts every source; the frame shows each in a cell of its own.
Frame wall(const Job& job, SourcePool& pool) {
    Frame frame{.canvas = {width, height}};
    const int across = width / job.columns;
    const int down = height / job.rows;
    for (int i = 0; i < job.columns * job.rows; ++i) {
        const auto source = static_cast<SourceId>(i + 1);
        const int left = i % job.columns * across;
        const int top = i / job.columns * down;
        pool.request({.source = source,
                      .path = job.files[static_cast<std::size_t>(i) % job.files.size()],
                      .kind = MediaKind::film,
                      .shot = {.begin = 0s, .end = shot},
                      .width = across,
                      .height = down});
        frame.items.push_back({.source = source,
                               .cell = cell(left, top, across, down),
                               .placement = {1, {static_cast<double>(left), static_cast<double>(top)}},
                               .picture = {static_cast<double>(across), static_cast<double>(down)}});
    }
    return frame;
}

void play(const Job& job) {
    OffscreenScreen screen({.width = width, .height = height});
    Renderer renderer(width, height);
    SourcePool pool({.media = "/"});
    Frame frame = wall(job, pool);
    for (const SourceEvent& event : pool.wait_until_ready(20s))
        if (event.failure) throw std::runtime_error(*event.failure);
    std::map<SourceId, std::shared_ptr<const void>> uploaded;
    int uploads = 0;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < job.seconds * rate; ++i) {
        const auto due = std::chrono::nanoseconds(1'000'000'000LL * i / rate);
        std::this_thread::sleep_until(start + due);
        pool.update();
        frame.time = due;
        for (DrawItem& item : frame.items)
            item.local = due;
        pool.advance(frame);
        for (const DrawItem& item : frame.items) {
            const auto sample = pool.sample(item.source);
            if (!sample || uploaded[item.source] == sample->owner) continue;
            renderer.upload(item.source, *sample);
            uploaded[item.source] = sample->owner;
            ++uploads;
        }
        if (!job.draws) continue;
        screen.begin_frame();
        renderer.draw(frame);
        screen.present(due);
    }
    fmt::print("{}: {} pictures of films shown, {} late\n", gl_device(), uploads, pool.late());
}

}  // namespace

int main(int count, char** words) {
    if (count < 6) {
        fmt::print("usage: wall_bench draw|upload COLUMNS ROWS SECONDS FILE...\n");
        return 2;
    }
    Job job{.draws = std::string(words[1]) == "draw",
            .columns = std::stoi(words[2]),
            .rows = std::stoi(words[3]),
            .seconds = std::stoi(words[4])};
    for (int i = 5; i < count; ++i)
        job.files.push_back(std::filesystem::absolute(words[i]));
    play(job);
}
