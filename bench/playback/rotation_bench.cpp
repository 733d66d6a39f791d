// Lets shots come and go on a wall of four, off screen, and prints what grows: resident memory, open files
// and threads every tenth of the way, and the slope of the memory over the second half.
//
//     rotation_bench FILE [ROTATIONS]
//
// FILE is a film of a second or more; of it each shot shows another half a second.

#include "player/display/offscreen_screen.hpp"
#include "player/playback/source_pool.hpp"
#include "player/render/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr int width = 320;  // px
constexpr int height = 180;
constexpr int slots = 4;
constexpr int pictures_a_turn = 3;

struct Footprint {
    double resident = 0;  // MiB
    long files = 0;
    long threads = 0;
};

Footprint footprint() {
    const auto count = [](const char* folder) {
        return static_cast<long>(std::distance(std::filesystem::directory_iterator(folder), {}));
    };
    std::ifstream stream("/proc/self/statm");
    double pages = 0;
    stream >> pages >> pages;
    return {.resident = pages * 4096 / (1 << 20),
            .files = count("/proc/self/fd"),
            .threads = count("/proc/self/task")};
}

std::shared_ptr<const Cell> cell(int slot) {
    const double across = static_cast<double>(width) / slots;
    const Vec2 a{slot * across, 0};
    const Vec2 b{(slot + 1) * across, 0};
    const Vec2 c{(slot + 1) * across, height};
    const Vec2 d{slot * across, height};
    return std::make_shared<const Cell>(Cell{.parts = {{a, b, c, d}}, .triangles = {{a, b, c}, {a, c, d}}});
}

/// One wall that shots come to and go from.
class Turning {
  public:
    explicit Turning(std::string file) : file_(std::move(file)) {
        for (int slot = 0; slot < slots; ++slot)
            frame_.items.push_back(
                {.source = asked(), .cell = cell(slot), .placement = {0.5, {}}, .picture = {160, 96}});
        ready();
    }

    /// The next shot takes the place of the one that has been there longest.
    void turn() {
        DrawItem& item = frame_.items[static_cast<std::size_t>(last_ % slots)];
        const SourceId leaves = item.source;
        item = {.source = asked(),
                .cell = cell(static_cast<int>(item.source % slots)),
                .placement = {0.5, {}},
                .picture = {160, 96}};
        ready();
        for (int i = 0; i < pictures_a_turn; ++i)
            show();
        pool_.retire(leaves);
        renderer_.forget(leaves);
        uploaded_.erase(leaves);
    }

  private:
    SourceId asked() {
        const auto source = ++last_;
        const auto begin = source % 20 * 10ms;
        pool_.request({.source = source,
                       .path = file_,
                       .kind = MediaKind::film,
                       .shot = {.begin = begin, .end = begin + 500ms},
                       .width = 80,
                       .height = 48});
        return source;
    }

    void ready() {
        for (const SourceEvent& event : pool_.wait_until_ready(20s))
            if (event.failure) throw std::runtime_error(*event.failure);
    }

    void show() {
        frame_.time += 33ms;
        for (DrawItem& item : frame_.items)
            item.local += 33ms;
        pool_.update();
        pool_.advance(frame_);
        for (const DrawItem& item : frame_.items) {
            const auto sample = pool_.sample(item.source);
            if (!sample || uploaded_[item.source] == sample->owner) continue;
            renderer_.upload(item.source, *sample);
            uploaded_[item.source] = sample->owner;
        }
        screen_.begin_frame();
        renderer_.draw(frame_);
        screen_.present(frame_.time);
    }

    std::string file_;
    OffscreenScreen screen_{{.width = width, .height = height}};
    Renderer renderer_{width, height};
    SourcePool pool_{{.media = "/"}, {.keeps_time = true}};
    std::map<SourceId, std::shared_ptr<const void>> uploaded_;
    Frame frame_{.canvas = {width, height}};
    SourceId last_ = 0;
};

/// MiB a thousand rotations, by least squares.
double slope(const std::vector<std::pair<double, double>>& points) {
    double x = 0;
    double y = 0;
    for (const auto& [rotations, resident] : points) {
        x += rotations / static_cast<double>(points.size());
        y += resident / static_cast<double>(points.size());
    }
    double covariance = 0;
    double variance = 0;
    for (const auto& [rotations, resident] : points) {
        covariance += (rotations - x) * (resident - y);
        variance += (rotations - x) * (rotations - x);
    }
    return variance > 0 ? 1000 * covariance / variance : 0;
}

void turn(const std::string& file, int rotations) {
    Turning wall(file);
    std::vector<std::pair<double, double>> second_half;
    for (int i = 1; i <= rotations; ++i) {
        wall.turn();
        if (i % std::max(1, rotations / 40) != 0) continue;
        const Footprint now = footprint();
        if (2 * i >= rotations) second_half.emplace_back(i, now.resident);
        if (i % std::max(1, rotations / 10) == 0)
            fmt::print("{:6} rotations: {:.1f} MiB, {} open files, {} threads\n", i, now.resident, now.files,
                       now.threads);
    }
    fmt::print("slope over the second half: {:.2f} MiB a thousand rotations\n", slope(second_half));
}

}  // namespace

int main(int count, char** words) {
    if (count < 2) {
        fmt::print("usage: rotation_bench FILE [ROTATIONS]\n");
        return 2;
    }
    turn(std::filesystem::absolute(words[1]), count > 2 ? std::stoi(words[2]) : 5000);
}
