// Measures how well and how fast shots are found: in edited films and exact composites with known
// transitions, and in films of one take, where every transition found is wrong. The same run measures
// ffmpeg's scdet, an adaptive detector and a plain histogram, each at the threshold that suits these very
// films best. They name no kinds, so a change that they report within a gradual transition counts as finding
// it.

#include "analyzer/film/frame_reader.hpp"
#include "analyzer/film/transition_detector.hpp"
#include "bench/analysis/cpu_time.hpp"
#include "bench/analysis/shot_peers.hpp"
#include "bench/analysis/tables.hpp"
#include "bench/analysis/transition_score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vitrine::analyzer {

namespace {

enum Peer : std::size_t { scdet, adaptive, histogram, peers };

constexpr std::array<const char*, peers> peer_names{"ffmpeg scdet", "adaptive", "plain histogram"};

struct Film {
    Truth truth;
    std::vector<Transition> found;
    std::array<std::vector<Suspicion>, peers> suspicions;
    double decode_seconds = 0;  // processor time
    double detect_seconds = 0;
    int frames = 0;
};

// Frames are read in batches so that the clock is asked rarely, and so that peers cost neither side anything.
class Reader {
  public:
    Reader(Film& film, const std::string& path) : film_(film), source_(open_media(path)) {}

    void run() {
        while (read()) {
            detect();
            ask_peers();
        }
        std::ranges::copy(detector_.finish(source_->info().duration), std::back_inserter(film_.found));
        film_.suspicions[adaptive] = adaptive_.finish();
        film_.suspicions[histogram] = histogram_.finish();
    }

  private:
    static constexpr std::size_t batch = 32;

    // Decoding runs in other threads as well.
    bool read() {
        frames_.clear();
        const double start = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
        while (frames_.size() < batch) {
            auto frame = source_->next();
            if (!frame) break;
            frames_.push_back(std::move(*frame));
        }
        film_.decode_seconds += cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - start;
        film_.frames += static_cast<int>(frames_.size());
        return !frames_.empty();
    }

    void detect() {
        const double process = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
        const double start = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
        for (const FilmFrame& frame : frames_)
            std::ranges::copy(detector_.push(features_of(frame)), std::back_inserter(film_.found));
        const double seconds = cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - start;
        film_.detect_seconds += seconds;
        film_.decode_seconds += cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - process - seconds;
    }

    void ask_peers() {
        const double process = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
        const double start = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
        for (const FilmFrame& frame : frames_) {
            adaptive_.push(frame);
            histogram_.push(features_of(frame));
        }
        const double seconds = cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - start;
        film_.decode_seconds += cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - process - seconds;
    }

    Film& film_;  // outlives the reader
    std::unique_ptr<FrameSource> source_;
    std::vector<FilmFrame> frames_;
    TransitionDetector detector_;
    AdaptiveDetector adaptive_;
    HistogramDetector histogram_;
};

std::vector<Transition> above(const std::vector<Suspicion>& suspicions, double threshold) {
    std::vector<Transition> cuts;
    for (const Suspicion& one : suspicions)
        if (one.score > threshold) cuts.push_back({one.time, one.time, ShotEnd::cut});
    return cuts;
}

std::string text(const Tally& tally) {
    return fmt::format("{:.3f} ({} found, {} missed, {} false)", tally.f1(), tally.found, tally.missed,
                       tally.false_alarms);
}

void print(const std::string& what, const Score& score, int in_one_take) {
    fmt::print("{:34} cuts {}  gradual {}  all {}  in films of one take {}\n", what, text(score.cuts),
               text(score.gradual), text(score.all), in_one_take);
}

struct Sum {
    Score score;
    int in_one_take = 0;

    void add(const Film& film, const Score& score_of_film, std::size_t found) {
        score += score_of_film;
        if (film.truth.is_one_take) in_one_take += static_cast<int>(found);
    }
};

Sum sum_above(const std::vector<Film>& films, Peer peer, double threshold) {
    Sum sum;
    for (const Film& film : films) {
        const auto cuts = above(film.suspicions[peer], threshold);
        sum.add(film, score_of(film.truth, cuts, Names::none), cuts.size());
    }
    return sum;
}

void print_peer(const std::vector<Film>& films, Peer peer) {
    std::vector<double> thresholds;
    for (const Film& film : films)
        for (const Suspicion& one : film.suspicions[peer])
            thresholds.push_back(one.score);
    if (thresholds.empty()) return fmt::print("{:34} not here\n", peer_names[peer]);
    std::ranges::sort(thresholds);
    constexpr int tried = 200;  // thresholds, ever rarer: most frames are no transition
    double best = 0;
    Sum best_sum;
    for (int i = 0; i < tried; ++i) {
        const double share =
            std::pow(static_cast<double>(thresholds.size()), -static_cast<double>(i) / tried);
        const auto rank = static_cast<std::size_t>(share * static_cast<double>(thresholds.size() - 1));
        const double threshold = thresholds[thresholds.size() - 1 - rank];
        const Sum sum = sum_above(films, peer, threshold);
        if (sum.score.all.f1() <= best_sum.score.all.f1()) continue;
        best = threshold;
        best_sum = sum;
    }
    print(fmt::format("{}, threshold {:.3g}", peer_names[peer], best), best_sum.score, best_sum.in_one_take);
}

Film measured(const Truth& truth, const TableInput& input) {
    Film film{.truth = truth, .found = {}, .suspicions = {}};
    const std::string path = (input.media / truth.file).string();
    Reader(film, path).run();
    film.suspicions[scdet] = scdet_scores(path);
    return film;
}

void print_film(const Film& film, const Score& score, bool is_verbose) {
    print(film.truth.file, score, film.truth.is_one_take ? static_cast<int>(film.found.size()) : 0);
    if (!is_verbose) return;
    for (const std::string& mistake : score.mistakes)
        fmt::print("    {}\n", mistake);
    fmt::print("    {} frames, decoding {:.2f} ms each, detection {:.3f} ms\n", film.frames,
               1e3 * film.decode_seconds / film.frames, 1e3 * film.detect_seconds / film.frames);
}

}  // namespace

void shots_table(const TableInput& input) {
    std::vector<Film> films;
    Sum sum;
    double decode = 0;
    double detect = 0;
    for (const Truth& truth : read_truths(input.media)) {
        const Film& film = films.emplace_back(measured(truth, input));
        const Score score = score_of(truth, film.found);
        print_film(film, score, input.is_verbose);
        sum.add(film, score, film.found.size());
        decode += film.decode_seconds;
        detect += film.detect_seconds;
    }
    print("TOTAL", sum.score, sum.in_one_take);
    for (const Peer peer : {scdet, adaptive, histogram})
        print_peer(films, peer);
    fmt::print("detection costs {:.1f} % of decoding\n", 100 * detect / decode);
}

}  // namespace vitrine::analyzer
