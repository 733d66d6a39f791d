// How well and how fast shots are found: on edited films and exact composites with known transitions, and on
// films of one take, where everything found is wrong. Beside it the plain way, one threshold on the colour
// histogram difference, at the threshold that suits these very films best.

#include "analyzer/video/frame_features.hpp"
#include "analyzer/video/frame_reader.hpp"
#include "analyzer/video/transition_detector.hpp"
#include "tests/bench/analysis/tables.hpp"
#include "tests/bench/analysis/transition_score.hpp"

#include <fmt/format.h>

#include <ctime>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace vitrine {
namespace {

double cpu_seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

struct Run {
    std::vector<Transition> found;
    std::vector<Transition> steps;  // begin: time of a frame; end: its colour difference in 1e-9
    double all_seconds = 0;         // of CPU, decoding and detecting
    double detect_seconds = 0;
    int frames = 0;
};

Run run(const std::string& path) {
    Run run;
    const double start = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
    const auto source = open_media(path);
    TransitionDetector detector;
    std::optional<FrameFeatures> last;
    while (const auto frame = source->next()) {
        const double before = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
        const FrameFeatures features = features_of(*frame);
        std::ranges::copy(detector.push(features), std::back_inserter(run.found));
        run.detect_seconds += cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - before;
        const double step = last ? colour_difference(*last, features) : 0;
        run.steps.push_back(
            {frame->time, std::chrono::nanoseconds(static_cast<std::int64_t>(step * 1e9)), ShotEnd::cut});
        last = features;
        ++run.frames;
    }
    std::ranges::copy(detector.finish(source->info().duration), std::back_inserter(run.found));
    run.all_seconds = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - start;
    return run;
}

std::vector<Transition> above(const std::vector<Transition>& steps, double threshold) {
    std::vector<Transition> cuts;
    for (const Transition& step : steps)
        if (static_cast<double>(step.end.count()) * 1e-9 > threshold)
            cuts.push_back({step.begin, step.begin, ShotEnd::cut});
    return cuts;
}

void print(const std::string& what, const Score& score) {
    const auto text = [](const Tally& t) {
        return fmt::format("{:.3f} ({} found, {} missed, {} false)", t.f1(), t.found, t.missed,
                           t.false_alarms);
    };
    fmt::print("{:34} cuts {}  gradual {}  all {}\n", what, text(score.cuts), text(score.gradual),
               text(score.all));
}

void add(Score& sum, const Score& score) {
    sum.cuts += score.cuts;
    sum.gradual += score.gradual;
    sum.all += score.all;
}

struct Film {
    Truth truth;
    Run run;
};

void print_baseline(const std::vector<Film>& films) {
    double best = 0;
    Score best_score;
    for (double threshold = .05; threshold < .8; threshold += .01) {
        Score sum;
        for (const Film& film : films)
            add(sum, score_of(film.truth, above(film.run.steps, threshold)));
        if (sum.cuts.f1() <= best_score.cuts.f1()) continue;
        best = threshold;
        best_score = sum;
    }
    print(fmt::format("plain histogram, best threshold {:.2f}", best), best_score);
    int alarms = 0;
    for (const Film& film : films)
        if (film.truth.file.starts_with("single/"))
            alarms += static_cast<int>(above(film.run.steps, best).size());
    fmt::print("  of these false alarms in films of one take: {}\n", alarms);
}

}  // namespace

void shots_table(const TableInput& input) {
    const std::string folder = input.media.string();
    std::vector<Truth> truths = read_truths(folder);
    for (const auto& entry : std::filesystem::directory_iterator(folder + "/single"))
        if (entry.is_regular_file()) truths.push_back({.file = "single/" + entry.path().filename().string()});
    std::vector<Film> films;
    Score sum;
    double all = 0;
    double detect = 0;
    for (const Truth& truth : truths) {
        films.push_back({truth, run(folder + "/" + truth.file)});
        const Run& last = films.back().run;
        const Score score = score_of(truth, last.found);
        print(truth.file, score);
        for (const std::string& mistake : score.mistakes)
            fmt::print("    {}\n", mistake);
        fmt::print("    {} frames, {:.2f} ms each, of it {:.3f} ms detection\n", last.frames,
                   1e3 * last.all_seconds / last.frames, 1e3 * last.detect_seconds / last.frames);
        add(sum, score);
        all += last.all_seconds;
        detect += last.detect_seconds;
    }
    print("TOTAL", sum);
    print_baseline(films);
    fmt::print("detection costs {:.1f} % of decoding\n", 100 * detect / (all - detect));
}

}  // namespace vitrine
