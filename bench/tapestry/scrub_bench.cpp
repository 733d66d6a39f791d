// Measures a finger that goes over a film's strip, at 60 events a second: how long it takes until the film
// above shows the moment under the finger, and what a frame costs with the processor drawing.
//
//     scrub_bench PLAYER TAPESTRY MEDIA [SECONDS]
//
// PLAYER is the player's program, which starts the readers; TAPESTRY is a folder as `vitrine-analyzer weave
// -o` writes it; MEDIA is the folder that the film lies in.

#include "base/media/still_picture.hpp"
#include "player/display/offscreen_screen.hpp"
#include "player/playback/reader/reader_host.hpp"
#include "player/playback/reader/upload_readers.hpp"
#include "player/playback/source_pool.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/tapestry/kept_frames.hpp"
#include "player/stage/tapestry_playback.hpp"

#include <GLES3/gl3.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

namespace {

constexpr Vec2 canvas{1280, 720};
constexpr double finger_y = 600;
constexpr auto event_time = 16'666'667ns;  // 60 a second
constexpr auto near_enough = 260ms;        // kept frames are half a second apart
constexpr auto same_picture = 45ms;

double cpu_milliseconds() {
    timespec spent{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &spent);
    return static_cast<double>(spent.tv_sec) * 1e3 + static_cast<double>(spent.tv_nsec) * 1e-6;
}

double share(std::vector<double> values, double part) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

/// Films come from readers, as they do in the player where the store has none.
SourceOptions options_of(const std::shared_ptr<ReaderHost>& host, const std::string& media) {
    SourceOptions options;
    options.uploads = upload_readers(host, media);
    options.keeps_time = true;
    return options;
}

/// The player around a strip, in real time.
class Bench {
  public:
    Bench(const std::string& player, const std::string& tapestry, const std::string& media)
        : host_(std::make_shared<ReaderHost>(std::vector<std::string>{player, "reader-host"})),
          pool_({.media = media, .store = {}}, options_of(host_, media)),
          strip_(tapestry, canvas, {.first_source = 1, .patience = {}, .film = {}}) {}

    void finger(Gesture::Kind kind, double x) {
        Gesture gesture;
        gesture.kind = kind;
        gesture.at = {x, finger_y};
        gesture.from = {100, finger_y};
        strip_.handle_gesture(gesture);
    }

    /// One frame, as the player makes it.
    void step() {
        const double before = cpu_milliseconds();
        for (const SourceEvent& event : pool_.update())
            event.failure ? strip_.source_failed(event.source) : strip_.source_ready(event.source);
        WallStep step = strip_.step(Clock::now() - start_, &renderer_);
        for (const ShotRequest& request : step.requests) {
            pool_.request(request);
            begins_[request.source] = request.shot.begin;
        }
        for (const SourceId source : step.retired) {
            pool_.retire(source);
            renderer_.forget(source);
        }
        frame_ = std::move(step.frame);
        pool_.advance(frame_);
        for (const DrawItem& item : frame_.items)
            if (const std::optional<Sample> sample = pool_.sample(item.source))
                renderer_.upload(item.source, *sample);
        screen_.begin_frame();
        renderer_.draw(frame_);
        glFinish();
        spent_ = cpu_milliseconds() - before;
    }

    double spent() const { return spent_; }

    /// The film's time under a point of the canvas.
    std::chrono::nanoseconds moment_at(double x) const {
        return strip_.show().place().time_at(strip_.show().view(), x);
    }

    /// True: the film above shows this moment in the last frame. @param is_sharp  not as a kept frame
    bool shows(std::chrono::nanoseconds moment, bool is_sharp) const {
        const Tapestry& tapestry = strip_.show().tapestry();
        const Box preview = tapestry_boxes(canvas, strip_.show().film().picture).preview;
        for (const DrawItem& item : frame_.items) {
            if (!item.cell || bounding_box(item.cell->parts[0]) != preview) continue;
            if (const auto found = begins_.find(item.source); found != begins_.end())
                return std::chrono::abs(found->second - moment) <= (is_sharp ? same_picture : near_enough);
            const PlacedCell kept = placed_frame(tapestry, moment, preview);
            return !is_sharp && item.source == strip_.show().sources().tile(kept.picture) &&
                   item.placement.offset == kept.offset;
        }
        return false;
    }

  private:
    OffscreenScreen screen_{{.width = 1280, .height = 720, .film = {}}};
    Renderer renderer_{1280, 720};
    std::shared_ptr<ReaderHost> host_;
    SourcePool pool_;
    TapestryPlayback strip_;
    std::map<SourceId, std::chrono::nanoseconds> begins_;
    Frame frame_;
    double spent_ = 0;
    Clock::time_point start_ = Clock::now();
};

struct Look {
    std::chrono::nanoseconds moment{0};
    Clock::time_point began;
};

/// The place of the finger: to and fro over the strip, faster and slower.
double finger_x(std::chrono::nanoseconds passed) {
    const double seconds = std::chrono::duration<double>(passed).count();
    return 640 - 480 * std::cos(seconds * (0.5 + 0.4 * std::sin(seconds / 3)));
}

/// Moves the finger for some seconds. A frame takes all events that are due, as the player does.
void measure_moving(Bench& bench, double seconds) {
    std::vector<double> delays;
    std::vector<double> costs;
    std::vector<Look> waiting;
    const auto began = Clock::now();
    const auto end =
        began + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    for (auto due = began; due < end;) {
        std::this_thread::sleep_until(due);
        for (; due <= Clock::now(); due += event_time) {
            bench.finger(Gesture::Kind::drag, finger_x(due - began));
            waiting.push_back({bench.moment_at(finger_x(due - began)), due});
        }
        bench.step();
        costs.push_back(bench.spent());
        const auto shown = std::ranges::find_if(waiting.rbegin(), waiting.rend(), [&](const Look& look) {
            return bench.shows(look.moment, false);
        });
        const auto now = Clock::now();
        for (auto look = shown; look != waiting.rend(); ++look)  // those before are overtaken
            delays.push_back(std::chrono::duration<double, std::milli>(now - look->began).count());
        waiting.erase(waiting.begin(), shown.base());
    }
    fmt::print("{} events, {} frames: picture after p50 {:.1f}, p95 {:.1f}, worst {:.1f} ms; {} without\n",
               delays.size() + waiting.size(), costs.size(), share(delays, 0.5), share(delays, 0.95),
               share(delays, 1), waiting.size());
    fmt::print("CPU a frame, all threads of the player: p50 {:.1f}, p95 {:.1f} ms\n", share(costs, 0.5),
               share(costs, 0.95));
    std::fflush(stdout);
}

/// Stops the finger at some places, and waits for the sharp picture.
void measure_stops(Bench& bench, int stops) {
    std::vector<double> delays;
    for (int k = 0; k < stops; ++k) {
        const double x = 150 + 980.0 * (k * 7 % stops) / stops;
        const auto began = Clock::now();
        bench.finger(Gesture::Kind::drag, x);
        while (Clock::now() - began < 5s) {
            bench.step();
            if (bench.shows(bench.moment_at(x), true)) break;
            std::this_thread::sleep_for(4ms);
        }
        delays.push_back(std::chrono::duration<double, std::milli>(Clock::now() - began).count());
    }
    fmt::print("{} stops: sharp picture after p50 {:.0f}, p95 {:.0f} ms\n", stops, share(delays, 0.5),
               share(delays, 0.95));
}

}  // namespace

int main(int count, char** words) {
    if (count < 4) {
        fmt::print("scrub_bench PLAYER TAPESTRY MEDIA [SECONDS]\n");
        return 2;
    }
    init_vips();
    Bench bench(words[1], words[2], words[3]);
    for (int k = 0; k < 90; ++k) {
        bench.step();
        std::this_thread::sleep_for(event_time);
    }
    bench.finger(Gesture::Kind::hold, 100);
    measure_moving(bench, count > 4 ? std::atof(words[4]) : 10);
    measure_stops(bench, 10);
    std::fflush(stdout);
    std::_Exit(0);  // readers of a film end with the process
}
