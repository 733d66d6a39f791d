// Plays one film in several sources at once, paced at a screen's rate without drawing, and prints what that
// costs: pictures late, processor seconds against decoding alone by the same chain, memory a source.
//
//     playback_bench FILE [SOURCES [SECONDS [WIDTH [RATE]]]]

#include "base/media/decode_chain.hpp"
#include "player/playback/source_pool.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <thread>

using namespace vitrine;
using namespace vitrine::player;

namespace {

struct Job {
    std::string file;
    int sources = 4;
    int seconds = 20;
    int width = 640;  // px that each is decoded to
    int rate = 15;    // pictures a second on the screen
};

/// The properties that a film declares.
struct Film {
    std::chrono::nanoseconds duration{0};
    int width = 0;
    int height = 0;
};

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](timeval time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double pss_mebibytes() {
    std::ifstream rollup("/proc/self/smaps_rollup");
    std::string word;
    while (rollup >> word) {
        if (word != "Pss:") continue;
        double kibibytes = 0;
        rollup >> kibibytes;
        return kibibytes / 1024;
    }
    return 0;
}

/// Decodes the whole film once into nothing. @return processor seconds for each second of film
double decode_alone(const std::string& path, Film& film) {
    start_gstreamer();
    DecodeChain chain(path, make_bin("fakesink name=end sync=false"));
    chain.preroll();
    film.duration = chain.duration();
    const GstPtr<GstElement> sink(gst_bin_get_by_name(GST_BIN(chain.tail()), "end"));
    const GstPtr<GstPad> pad(gst_element_get_static_pad(sink.get(), "sink"));
    const GstPtr<GstCaps> caps(gst_pad_get_current_caps(pad.get()));
    const GstStructure* format = gst_caps_get_structure(caps.get(), 0);
    gst_structure_get_int(format, "width", &film.width);
    gst_structure_get_int(format, "height", &film.height);
    const double before = cpu_seconds();
    gst_element_set_state(chain.pipeline(), GST_STATE_PLAYING);
    const GstPtr<GstMessage> end(gst_bus_timed_pop_filtered(
        chain.bus(), GST_CLOCK_TIME_NONE, static_cast<GstMessageType>(GST_MESSAGE_EOS | GST_MESSAGE_ERROR)));
    return (cpu_seconds() - before) / std::chrono::duration<double>(film.duration).count();
}

void play(const Job& job, const Film& film, double alone) {
    const double before_pss = pss_mebibytes();
    SourcePool pool({.media = ".", .store = "."});
    Frame frame;
    for (int i = 1; i <= job.sources; ++i) {
        const auto source = static_cast<SourceId>(i);
        pool.request({.source = source,
                      .path = job.file,
                      .kind = MediaKind::film,
                      .shot = {.begin = film.duration / 4, .end = film.duration * 3 / 4},
                      .width = job.width,
                      .height = job.width * film.height / film.width});
        frame.items.push_back({.source = source});
    }
    pool.wait_until_ready(std::chrono::seconds(60));
    const double before = cpu_seconds();
    const auto start = std::chrono::steady_clock::now();
    double pss = 0;
    for (int i = 0; i < job.seconds * job.rate; ++i) {
        const auto due = std::chrono::nanoseconds(1'000'000'000LL * i / job.rate);
        std::this_thread::sleep_until(start + due);
        pool.update();
        for (DrawItem& item : frame.items)
            item.local = due;
        pool.advance(frame);
        if (i % job.rate == 0) pss = std::max(pss, pss_mebibytes());
    }
    const double cpu = cpu_seconds() - before;
    fmt::print("{} sources of {}x{} to {} px wide at {} a second for {} s: {} pictures late, {:.2f} CPU-s, "
               "{:.2f} times decoding alone, {:.1f} MiB PSS a source\n",
               job.sources, film.width, film.height, job.width, job.rate, job.seconds, pool.late(), cpu,
               cpu / (alone * job.seconds * job.sources), (pss - before_pss) / job.sources);
}

}  // namespace

int main(int count, char** words) {
    if (count < 2) {
        fmt::print("usage: playback_bench FILE [SOURCES [SECONDS [WIDTH [RATE]]]]\n");
        return 2;
    }
    Job job{.file = std::filesystem::relative(words[1])};
    int* const numbers[] = {&job.sources, &job.seconds, &job.width, &job.rate};
    for (int i = 2; i < std::min(count, 6); ++i)
        *numbers[i - 2] = std::max(1, std::stoi(words[i]));
    Film film;
    const double alone = decode_alone(job.file, film);
    play(job, film, alone);
    return 0;
}
