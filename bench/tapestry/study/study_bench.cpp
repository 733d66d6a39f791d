// Searches scenes of films by three interfaces and counts the steps: the study of Video Tapestries 6,
// repeated by machine.
//     study_bench FOLDER WOVEN [--scenes 10] [--seed 1] [--film PART]
//
// FOLDER/*/gt/*.json are the truths of films with shots; the films lie in FOLDER. WOVEN/STEM is the tapestry
// of a film, where STEM is the film's name without its ending and "/" becomes "-". The scenes are frames
// chosen at random within shots of a second or more, none of them a keyframe or a frame of the filmstrip.

#include "analyzer/film/frame_reader.hpp"
#include "bench/analysis/transition_score.hpp"
#include "bench/tapestry/study/interfaces.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <random>
#include <set>

using namespace vitrine;
using namespace vitrine::study;
namespace fs = std::filesystem;
using std::chrono::nanoseconds;

namespace {

constexpr int frame_size = 320;  // px, longest side; the interfaces draw a quarter of the screen's size
constexpr auto apart = std::chrono::milliseconds(100);  // a sought frame from all frames that are drawn
constexpr std::array<const char*, 3> names{"strip", "filmstrip", "scrollbar"};

/// The options of the study.
struct Study {
    fs::path folder;
    fs::path woven;
    int scenes = 10;
    unsigned seed = 1;
    std::string part;  // of the names of films
};

/// A moment that is sought, and its shot.
struct Target {
    nanoseconds moment{0};
    Stretch shot;
};

bool is_drawn(const Tapestry& tapestry, const std::vector<std::vector<nanoseconds>>& filmstrip,
              nanoseconds moment) {
    const auto near = [&](nanoseconds time) { return std::chrono::abs(time - moment) < apart; };
    return std::ranges::any_of(tapestry.levels.back().keyframes, near) ||
           std::ranges::any_of(filmstrip,
                               [&](const auto& level) { return std::ranges::any_of(level, near); });
}

/// The film stands in its first shot, so that is not sought.
std::vector<Target> chosen_targets(const Study& study, const analyzer::Truth& truth, const Tapestry& tapestry,
                                   const std::vector<std::vector<nanoseconds>>& filmstrip) {
    std::vector<Stretch> shots;
    for (const Stretch& shot : truth.pictures)
        if (shot.end - shot.begin >= std::chrono::seconds(1) && shot.begin > nanoseconds(0))
            shots.push_back(shot);
    std::vector<Target> targets;
    std::mt19937 random(study.seed);
    for (int tries = 0; tries < 1000 && !shots.empty() && std::ssize(targets) < study.scenes; ++tries) {
        const Stretch& shot = shots[random() % shots.size()];
        const auto length = static_cast<std::uint64_t>((shot.end - shot.begin).count());
        const std::uint64_t number = (std::uint64_t{random()} << 32U) | random();
        const nanoseconds moment = shot.begin + nanoseconds(static_cast<std::int64_t>(number % length));
        if (!is_drawn(tapestry, filmstrip, moment)) targets.push_back({.moment = moment, .shot = shot});
    }
    return targets;
}

/// Reads the film once. @return for every time the first frame not before it, by the frame's own time
FrameTable read_frames(analyzer::FrameSource& source, const std::set<nanoseconds>& times) {
    FrameTable frames;
    std::optional<analyzer::FilmFrame> last;
    auto next = times.begin();
    while (std::optional<analyzer::FilmFrame> frame = source.next()) {
        if (next != times.end() && frame->time >= *next) {
            frames[frame->time] = frame->picture.clone();
            while (next != times.end() && *next <= frame->time)
                ++next;
        }
        last = std::move(frame);
    }
    if (last && frames.empty()) frames[last->time] = last->picture.clone();
    return frames;
}

/// The steps of every search, by interface.
using Steps = std::array<std::vector<int>, names.size()>;

double median(std::vector<int> values) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

void print_row(const std::string& name, const Steps& steps) {
    fmt::print("{:32} {:4} scenes", name, steps[0].size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        double sum = 0;
        for (const int count : steps[i])
            sum += count;
        const auto lost = std::ranges::count(steps[i], max_steps);
        fmt::print(" | {} median {:5.1f} mean {:5.1f} not found {}", names[i], median(steps[i]),
                   steps[i].empty() ? 0 : sum / static_cast<double>(steps[i].size()), lost);
    }
    fmt::print("\n");
}

Steps study_film(const Study& study, const analyzer::Truth& truth) {
    std::string stem = fs::path(truth.file).replace_extension().string();
    std::ranges::replace(stem, '/', '-');
    const fs::path woven = study.woven / stem;
    const Tapestry tapestry = read_tapestry(woven);
    const auto source = analyzer::open_media((study.folder / truth.file).string(), frame_size);
    const cv::Size shape{source->info().width, source->info().height};
    const auto filmstrip = filmstrip_times(tapestry, shape);
    const std::vector<Target> targets = chosen_targets(study, truth, tapestry, filmstrip);
    std::set<nanoseconds> times;
    for (const auto& level : filmstrip)
        times.insert(level.begin(), level.end());
    for (const Target& target : targets)
        times.insert(target.moment);
    const FrameTable frames = read_frames(*source, times);
    const std::array<SearchedInterface, names.size()> interfaces{tapestry_interface(woven, tapestry, shape),
                                                                 filmstrip_interface(tapestry, shape, frames),
                                                                 scrollbar_interface(tapestry)};
    Steps steps;
    for (const Target& target : targets) {
        const auto frame = frames.lower_bound(target.moment);
        if (frame == frames.end()) continue;
        const SoughtScene scene{
            .frame = frame->second, .shot_begin = target.shot.begin, .shot_end = target.shot.end};
        for (std::size_t i = 0; i < names.size(); ++i)
            steps[i].push_back(count_steps(interfaces[i], scene));
    }
    return steps;
}

int run(const Study& study) {
    Steps all;
    for (const analyzer::Truth& truth : analyzer::read_truths(study.folder)) {
        if (truth.is_one_take || truth.file.find(study.part) == std::string::npos) continue;
        const Steps steps = study_film(study, truth);
        print_row(truth.file, steps);
        std::fflush(stdout);
        for (std::size_t i = 0; i < names.size(); ++i)
            all[i].insert(all[i].end(), steps[i].begin(), steps[i].end());
    }
    print_row("all", all);
    return all[0].empty() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    Study study;
    CLI::App app("Counts the steps to a scene of a film, by three interfaces.");
    app.add_option("FOLDER", study.folder)->required();
    app.add_option("WOVEN", study.woven)->required();
    app.add_option("--scenes", study.scenes, "Scenes of a film");
    app.add_option("--seed", study.seed, "Of the choice of scenes");
    app.add_option("--film", study.part, "Only films whose name holds this");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(study);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
