// Measures how much of a film the wall can show: of the seconds that are neither transition, black nor title
// by the truth, those that lie in a shot. And for films of one take the longest stretch of a shot, over the
// seam of its loop as well, in which nothing moves though something does elsewhere in the take.

#include "analyzer/film/frame_reader.hpp"
#include "analyzer/one_file/analyze.hpp"
#include "analyzer/saliency/take_parts.hpp"
#include "base/state/media_error.hpp"
#include "bench/analysis/tables.hpp"
#include "bench/analysis/transition_score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <string_view>

namespace vitrine::analyzer {

namespace {

using std::chrono::nanoseconds;

// No threshold was chosen on these films.
constexpr std::array held_back{"composites/gradual_640x360_25.mp4", "edited/nasa_13013_320x180.mp4"};
constexpr double moves = .003;  // share of the picture that changes in a fifth of a second

double seconds(nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

AnalysisSettings settings_of(const TableInput& input) {
    AnalysisSettings settings;
    settings.face_model = input.face_model;
    return settings;
}

nanoseconds shown_of(const Stretch& picture, const MediaRecord& record) {
    nanoseconds sum{0};
    for (const Shot& shot : record.shots)
        sum +=
            std::max(nanoseconds(0), std::min(picture.end, shot.end) - std::max(picture.begin, shot.begin));
    return sum;
}

struct Share {
    double pictures = 0;  // s
    double shown = 0;

    void print(std::string_view name) const {
        fmt::print("{:36} {:>8.2f} {:>8.2f} {:>8.3f}\n", name, pictures, shown,
                   pictures > 0 ? shown / pictures : 0);
    }
};

Share share_of(const Truth& truth, const MediaRecord& record, bool is_verbose) {
    Share share;
    for (const Stretch& picture : truth.pictures) {
        const double shown = seconds(shown_of(picture, record));
        share.pictures += seconds(picture.end - picture.begin);
        share.shown += shown;
        if (is_verbose && shown < .9 * seconds(picture.end - picture.begin))
            fmt::print("    of {:.2f}-{:.2f} s only {:.2f} s\n", seconds(picture.begin), seconds(picture.end),
                       shown);
    }
    return share;
}

/// The times of samples, five a second, and the share of the picture that has changed since the last.
struct Moments {
    std::vector<nanoseconds> times;
    std::vector<double> changed;
};

Moments moments_of(FrameSource& source) {
    Moments moments;
    cv::Mat before;
    while (const auto frame = source.next()) {
        if (!moments.times.empty() && frame->time - moments.times.back() < std::chrono::milliseconds(200))
            continue;
        moments.changed.push_back(before.empty() ? 0 : changed_share(before, frame->picture));
        moments.times.push_back(frame->time);
        before = frame->picture;
    }
    return moments;
}

/// The longest stretch of a shot that loops in which nothing moves; 0 if it moves nowhere in the take.
nanoseconds longest_rest(const Moments& moments, const Shot& shot) {
    if (std::ranges::none_of(moments.changed, [](double share) { return share > moves; })) return {};
    std::vector<nanoseconds> ends;  // of rests: times at which something moves
    for (std::size_t i = 0; i < moments.times.size(); ++i)
        if (moments.times[i] > shot.begin && moments.times[i] < shot.end && moments.changed[i] > moves)
            ends.push_back(moments.times[i]);
    if (ends.empty()) return shot.duration();
    nanoseconds longest = ends.front() - shot.begin + (shot.end - ends.back());
    for (std::size_t i = 1; i < ends.size(); ++i)
        longest = std::max(longest, ends[i] - ends[i - 1]);
    return longest;
}

double rest_of(const std::string& path, const MediaRecord& record) {
    const auto source = open_media(path);
    const Moments moments = moments_of(*source);
    nanoseconds longest{0};
    for (const Shot& shot : record.shots)
        longest = std::max(longest, longest_rest(moments, shot));
    return seconds(longest);
}

std::optional<MediaRecord> record_of(const std::string& path, const TableInput& input) {
    try {
        return analyze(*open_media(path), settings_of(input));
    } catch (const MediaError& error) {
        fmt::print("{}: {}\n", path, error.what());
        return std::nullopt;
    }
}

}  // namespace

void shown_table(const TableInput& input) {
    fmt::print("\nshown: seconds of pictures by the truth, those in a shot, their share\n");
    Share all;
    Share held;
    double longest = 0;
    for (const Truth& truth : read_truths(input.media)) {
        const std::string path = (input.media / truth.file).string();
        const auto record = record_of(path, input);
        if (!record) continue;
        if (truth.is_one_take) {
            const double rest = rest_of(path, *record);
            fmt::print("{:36} {} shots, longest rest {:.1f} s\n", truth.file, record->shots.size(), rest);
            longest = std::max(longest, rest);
            continue;
        }
        const Share share = share_of(truth, *record, input.is_verbose);
        const bool is_held = std::ranges::find(held_back, truth.file) != held_back.end();
        share.print(truth.file + (is_held ? " (held back)" : ""));
        for (Share* sum : {&all, is_held ? &held : nullptr})
            if (sum != nullptr) *sum = {sum->pictures + share.pictures, sum->shown + share.shown};
    }
    all.print("TOTAL");
    held.print("of it held back");
    fmt::print("longest stretch of a place in which nothing stands out, single takes: {:.1f} s\n", longest);
}

}  // namespace vitrine::analyzer
