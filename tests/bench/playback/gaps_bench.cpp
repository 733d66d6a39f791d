// Counts pictures lost, repeated or at a wrong distance over many loops of a part of a film, in several
// containers: eight pictures from the midst, so that a thousand loops take seconds.
//
//     gaps_bench [LOOPS]

#include "player/playback/film_loop.hpp"
#include "tests/player/playback/numbered_film.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <utility>

using namespace vitrine;
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
        fmt::print("{}: {} loops, {} pictures lost or repeated, {} gaps of other than one picture\n", name,
                   loops, found.pictures, found.distances);
        std::fflush(stdout);
    }
}
