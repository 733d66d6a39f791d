// Measures what changes of a large catalogue cost the player's main thread, and how late they are seen.
//   catalogue_bench [RECORDS [SECONDS]]
// The main thread follows the catalogue and gives its files to a wall, at 30 ticks a second; nothing is
// decoded or drawn. A tick counts as late where it begins more than half a frame after its time. Another
// thread changes records: none, one in two seconds, twenty a second. The wall's shots change meanwhile as on
// a screen. Processor time of the main thread does not depend on what else runs; late ticks do.

#include "base/state/record_json.hpp"
#include "base/system/log.hpp"
#include "player/content/visible_files.hpp"
#include "player/scene/wall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <optional>
#include <thread>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

constexpr Vec2 canvas{1920, 1080};
constexpr std::chrono::nanoseconds frame{1'000'000'000 / 30};
constexpr double max_change_ms = 5;  // of the main thread for one change
constexpr double max_lag_ms = 500;   // from the change of a file to the list

double to_ms(std::chrono::nanoseconds time) {
    return std::chrono::duration<double, std::milli>(time).count();
}

std::chrono::nanoseconds thread_time() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

MediaRecord record(int number, std::int64_t mtime) {
    return {
        .path = fmt::format("folder {:03}/picture {:06}.jpg", number % 300, number),
        .bytes = 1000,
        .mtime_ns = mtime,
        .state = MediaState::ready,
        .width = 640,
        .height = 360,
        .shots = {{.region = {.polygon = {{240, 120}, {400, 120}, {400, 240}, {240, 240}}, .drift = {}}}}};
}

/// A state directory with a catalogue that a thread changes.
class State {
  public:
    explicit State(int count) : count_(count) {
        std::string name = (fs::temp_directory_path() / "vitrine-bench-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) std::exit(1);
        path_ = name;
        fs::create_directories(catalogue());
        for (int i = 0; i < count; ++i)
            write(record(i, 1));
    }

    State(const State&) = delete;
    State& operator=(const State&) = delete;

    ~State() { fs::remove_all(path_); }

    const fs::path& path() const { return path_; }

    /// Changes one record. @return  it
    MediaRecord change() {
        MediaRecord next = record(static_cast<int>(changes_ * 7919 % count_), changes_ + 2);
        ++changes_;
        write(next);
        return next;
    }

  private:
    fs::path catalogue() const { return path_ / "catalogue"; }

    void write(const MediaRecord& record) const {
        const fs::path file = catalogue() / (record_id(record.path) + ".json");
        std::ofstream(file.string() + ".new", std::ios::binary) << to_json(record);
        fs::rename(file.string() + ".new", file);
    }

    int count_;
    std::int64_t changes_ = 0;
    fs::path path_;
};

/// The change that the main thread has yet to see.
struct Awaited {
    std::mutex mutex;
    std::optional<MediaRecord> record;
    Clock::time_point since;
};

struct Figures {
    int ticks = 0, late = 0, changes = 0;
    std::chrono::nanoseconds longest{0};    // that a tick began after its time
    std::chrono::nanoseconds processor{0};  // of the main thread
    std::chrono::nanoseconds lag{0};        // the longest
};

/// The main thread of a player.
class MainThread {
  public:
    explicit MainThread(const State& state)
        : files_(loop_, state.path(), {}, nullptr, [this] { give_files(); }) {
        is_made_ = true;
        give_files();
    }

    Figures run(State& state, std::chrono::nanoseconds interval, std::chrono::seconds length) {
        Figures figures;
        std::atomic<bool> is_over = false;
        Awaited awaited;
        std::thread writer([&] {
            for (auto next = Clock::now() + interval; interval > 0ns && !is_over; next += interval) {
                std::this_thread::sleep_until(next);
                const auto since = Clock::now();
                MediaRecord changed = state.change();
                ++figures.changes;
                const std::lock_guard lock(awaited.mutex);
                if (!awaited.record) awaited.record = std::move(changed), awaited.since = since;
            }
        });
        const auto begin = Clock::now();
        const auto used = thread_time();
        for (auto due = begin; due < begin + length; due += frame) {
            for (auto now = Clock::now(); now < due; now = Clock::now())
                loop_.run_once(due - now);
            tick(due, figures);
            see(awaited, figures);
        }
        figures.processor = thread_time() - used;
        is_over = true;
        writer.join();
        return figures;
    }

  private:
    void give_files() {
        if (is_made_) wall_.set_catalogue(files_.records(), files_.hints());
    }

    /// Looks at the files as the player does, with another wall every three seconds.
    void tick(Clock::time_point due, Figures& figures) {
        const auto behind = Clock::now() - due;
        ++figures.ticks;
        if (behind > frame / 2) ++figures.late;
        figures.longest = std::max<std::chrono::nanoseconds>(figures.longest, behind);
        time_ += frame;
        files_.look(time_, Clock::now(), [&] {
            const auto shown = static_cast<int>(time_ / 3s);
            return WallContent{.folders = {{}}, .files = {record(shown, 1).path}, .open = {}};
        });
    }

    void see(Awaited& awaited, Figures& figures) {
        const std::lock_guard lock(awaited.mutex);
        if (!awaited.record) return;
        const RecordList::Record now = files_.catalogue().find(awaited.record->path);
        if (!now || now->mtime_ns < awaited.record->mtime_ns) return;
        figures.lag = std::max<std::chrono::nanoseconds>(figures.lag, Clock::now() - awaited.since);
        awaited.record.reset();
    }

    EventLoop loop_;
    Wall wall_{canvas, {}};
    bool is_made_ = false;
    std::chrono::nanoseconds time_{0};
    VisibleFiles files_;
};

}  // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::atoi(argv[1]) : 60'000;
    const auto length = std::chrono::seconds(argc > 2 ? std::atoi(argv[2]) : 20);
    log::set_level(log::Level::warning);
    State state(count);
    MainThread player(state);
    player.run(state, 0ns, 2s);  // what a start still leaves to do
    fmt::print("{} records\n\n| changes | late ticks | latest ms | main thread ms a change | of {} ms | lag "
               "ms | of {} ms |\n"
               "|--|--|--|--|--|--|--|\n",
               count, max_change_ms, max_lag_ms);
    Figures quiet;
    for (const auto interval : {std::chrono::milliseconds(0), 2000ms, 50ms}) {
        const Figures figures = player.run(state, interval, length);
        if (interval == 0ms) quiet = figures;
        const double change =
            figures.changes == 0 ? 0 : to_ms(figures.processor - quiet.processor) / figures.changes;
        fmt::print("| {} | {} of {} | {:.1f} | {:.2f} | {:.3f} | {:.0f} | {:.2f} |\n", figures.changes,
                   figures.late, figures.ticks, to_ms(figures.longest), change, change / max_change_ms,
                   to_ms(figures.lag), to_ms(figures.lag) / max_lag_ms);
        std::fflush(stdout);
    }
}
