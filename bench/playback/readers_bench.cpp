// The processor time of films that readers decode, against the same films decoded in this process: four at a
// time, as many pictures of each as the decoders give, drawn by nobody.
//
//     readers_bench READER_HOST FILM [PICTURES]        READER_HOST: tests/player/playback/test_reader_host

#include "player/playback/film_loop.hpp"
#include "player/playback/reader/upload_readers.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr int films = 4;
constexpr int shown_width = 640;  // px, on the wall
constexpr int shown_height = 360;

double own_time() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Processor time of another process that runs, in seconds.
double time_of(pid_t process) {
    std::ifstream file(fmt::format("/proc/{}/stat", process));
    std::string text;
    std::getline(file, text);
    std::istringstream words(text.substr(text.rfind(')') + 1));
    std::string word;
    double ticks = 0;
    for (int i = 3; words >> word && i <= 15; ++i)
        if (i >= 14) ticks += std::stod(word);
    return ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

double time_of_readers(pid_t host) {
    std::ifstream list(fmt::format("/proc/{0}/task/{0}/children", host));
    double time = time_of(host);
    for (pid_t reader = 0; list >> reader;)
        time += time_of(reader);
    return time;
}

/// Takes that many pictures of each film. @return seconds of all processes, without the start
double cost(const FilmFactory& make, const FilmPart& part, int pictures, pid_t host) {
    std::vector<std::unique_ptr<SampleQueue>> queues;
    std::vector<std::unique_ptr<FilmFeed>> playing;
    for (int i = 0; i < films; ++i) {
        queues.push_back(std::make_unique<SampleQueue>(12));
        playing.push_back(make(part, *queues.back(), {}));
    }
    const auto take = [&](int count) {
        for (int i = 0; i < count; ++i)
            for (const auto& queue : queues)
                if (!queue->wait(20s) || !queue->take_if([](const LoopedSample&) { return true; }))
                    throw std::runtime_error("a film has stopped");
    };
    take(10);
    const double before = own_time() + (host > 0 ? time_of_readers(host) : 0);
    take(pictures);
    return own_time() + (host > 0 ? time_of_readers(host) : 0) - before;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return std::fprintf(stderr, "readers_bench READER_HOST FILM [PICTURES]\n"), 2;
    const std::filesystem::path film = std::filesystem::absolute(argv[2]);
    const int pictures = argc > 3 ? std::stoi(argv[3]) : 300;
    const FilmPart part{.file = film, .begin = 0s, .end = 1h, .width = shown_width, .height = shown_height};
    const auto host = std::make_shared<ReaderHost>(std::vector<std::string>{argv[1]});
    const UploadFactories readers = upload_readers(host, film.parent_path());
    const FilmFactory here = [](const FilmPart& its, SampleQueue& queue, const FilmOptions& options) {
        return std::make_unique<FilmLoop>(its, queue, options);
    };
    for (int round = 0; round < 3; ++round) {
        const double alone = cost(here, part, pictures, 0);
        const double remote = cost(readers.make_film, part, pictures, host->process());
        std::printf(
            "%d films, %d pictures each: here %.2f s, by readers %.2f s of processor time: %.2f times\n",
            films, pictures, alone, remote, remote / alone);
    }
    return 0;
}
