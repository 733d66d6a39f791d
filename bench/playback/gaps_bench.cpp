// Counts pictures lost, repeated or at a wrong distance over many loops of a part of a film, in several
// containers: eight pictures from the midst, so that a thousand loops take seconds. Then the same over as
// many changes of shot, from films and from a clip as the store has it.
//
//     gaps_bench [LOOPS]

#include "player/playback/film_loop.hpp"
#include "player/playback/source_pool.hpp"
#include "tests/player/playback/numbered_film.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr int first = 40;
constexpr int count = 8;
constexpr auto period = 40ms;

struct Wrong {
    int pictures = 0;   // not the one that was to come
    int distances = 0;  // to the one before, of more or less than a picture
};

Wrong wrong(const std::string& file, int loops) {
    SampleQueue queue(12);
    const FilmLoop loop({.file = file,
                         .begin = first * period,
                         .end = (first + count) * period,
                         .width = numbered_width,
                         .height = numbered_height},
                        queue);
    Wrong wrong;
    std::chrono::nanoseconds before = -period;
    for (int i = 0; i < loops * count; ++i) {
        if (!queue.wait(20s)) return {loops * count - i, loops * count - i};
        const auto taken = queue.take_if([](const LoopedSample&) { return true; });
        const auto place =
            static_cast<int>(taken->loop) * count * period + taken->sample.stream_time - first * period;
        if (number(taken->sample) != first + i % count) ++wrong.pictures;
        const auto distance = place - std::exchange(before, place);
        if (distance < period - 2ms || distance > period + 2ms) ++wrong.distances;  // Matroska counts in ms
    }
    return wrong;
}

/// Each shot comes while the one before plays on beside it, as in a fade, and then plays alone up to the
/// next.
Wrong wrong_changes(const std::string& file, int changes, int begins) {
    SourcePool pool({.media = "/"});
    const auto ask = [&](int shot) {
        pool.request({.source = static_cast<SourceId>(shot + 1),
                      .path = file,
                      .kind = MediaKind::film,
                      .shot = {.begin = begins * period, .end = (begins + count) * period},
                      .width = numbered_width,
                      .height = numbered_height});
        for (const SourceEvent& event : pool.wait_until_ready(20s))
            if (event.failure) throw std::runtime_error(*event.failure);
    };
    Wrong wrong;
    std::map<SourceId, std::chrono::nanoseconds> last;
    constexpr int turn = count;      // pictures from one change to the next
    constexpr int fade = count / 2;  // pictures that show both shots
    ask(0);
    for (int tick = 0; tick < changes * turn; ++tick) {
        const int shot = tick / turn;
        if (tick % turn == turn - 1) ask(shot + 1);
        if (tick % turn == fade && shot > 0) pool.retire(static_cast<SourceId>(shot));
        Frame frame{.time = tick * period};
        for (int s = tick % turn < fade && shot > 0 ? shot - 1 : shot; s <= shot; ++s)
            frame.items.push_back(
                {.source = static_cast<SourceId>(s + 1), .local = (tick - s * turn) * period});
        pool.update();
        if (!pool.wait_for(frame, 20s)) return {changes * turn - tick, changes * turn - tick};
        pool.advance(frame);
        for (const DrawItem& item : frame.items) {
            const Sample sample = pool.sample(item.source).value();
            const auto local = static_cast<int>(item.local / period);
            if (number(sample) != begins + local % count) ++wrong.pictures;
            const auto at = sample.stream_time - begins * period + local / count * count * period;
            const auto [before, is_first] = last.try_emplace(item.source, at);
            const auto distance = at - std::exchange(before->second, at);
            if (is_first ? at > 2ms : distance < period - 2ms || distance > period + 2ms) ++wrong.distances;
        }
    }
    return wrong;
}

void tell(const std::string& what, const Wrong& found) {
    fmt::print("{}, {} pictures lost or repeated, {} gaps of other than one picture\n", what, found.pictures,
               found.distances);
    std::fflush(stdout);
}

}  // namespace

int main(int arguments, char** words) {
    const int loops = arguments > 1 ? std::stoi(words[1]) : 1000;
    const std::string h264 = "x264enc bframes=2 b-adapt=false key-int-max=25 speed-preset=veryfast ! ";
    const std::pair<const char*, std::string> containers[] = {
        {"mp4 with B-frames", h264 + "mp4mux"},
        {"mov of pictures", "jpegenc ! qtmux"},
        {"matroska with B-frames", h264 + "matroskamux"},
        {"webm", "vp8enc deadline=1 keyframe-max-dist=25 ! webmmux"},
        {"avi", "avenc_mpeg4 gop-size=25 ! avimux"},
    };
    const Folder folder;
    for (const auto& [name, chain] : containers) {
        write_film(folder.path / "film", {.pictures = 100, .rate = 25, .chain = chain});
        const Wrong found = wrong(folder.path / "film", loops);
        tell(fmt::format("{}: {} loops", name, loops), found);
        tell(fmt::format("{}: {} changes", name, loops), wrong_changes(folder.path / "film", loops, first));
    }
    write_film(folder.path / "clip",
               {.pictures = count,
                .rate = 25,
                .chain = "x264enc bframes=0 key-int-max=25 tune=fastdecode speed-preset=veryfast ! mp4mux"});
    tell(fmt::format("clip: {} changes", loops), wrong_changes(folder.path / "clip", loops, 0));
}
