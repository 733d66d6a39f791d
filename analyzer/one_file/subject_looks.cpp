#include "analyzer/one_file/subject_looks.hpp"

#include "analyzer/one_file/subject_network.hpp"
#include "analyzer/saliency/motion_contrast.hpp"
#include "analyzer/saliency/subject_outline.hpp"
#include "base/system/log.hpp"

#include <opencv2/core.hpp>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace vitrine::analyzer {
namespace {

// A look of the large network at 160 px takes about .09 s of processor time, as long as decoding 10 pictures
// of 1080p or 45 of 720p. So its looks add a twelfth to what decoding of 1080p costs, and a sixth to that of
// 720p. The student takes a seventh of that time; more looks than these made regions larger and no better.
constexpr LookPace network_pace{.pixels = 9e6, .seconds = 3, .at_once = 2, .max = 6};
constexpr LookPace student_pace{.pixels = 4.5e6, .seconds = 2, .at_once = 4, .max = 8};
constexpr double min_rate = 0.1;
constexpr int max_spare = 2;  // looks of the spare network at a shot
// A subject that moves or grows differs most at both ends of a shot, so the first and the last look are near
// them.
constexpr double margin = 0.1;       // from an end to the look nearest to it, in distances of two looks
constexpr double busy_share = 0.25;  // of the largest moving share of the samples: from there on one is busy
constexpr double min_mass = 0.003;   // of the picture: a smaller subject is none

double seconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

/// The share of a sample's picture that moves by itself; motion across the shot's begin does not count.
double moving_share(const Sample& sample, const Shot& shot) {
    if (sample.motion.empty() || sample.pair_time < shot.begin) return 0;
    return cv::countNonZero(sample.motion >= strong_motion) / static_cast<double>(sample.motion.total());
}

/// The sample nearest to another one in which much moves and at which the network has not looked. Null: none.
Sample* busy_sample_near(const Sample& near, const Shot& shot, std::vector<Sample>& samples) {
    std::vector<double> shares;
    shares.reserve(samples.size());
    for (const Sample& sample : samples)
        shares.push_back(moving_share(sample, shot));
    const double least = busy_share * *std::ranges::max_element(shares);
    Sample* best = nullptr;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        Sample& sample = samples[i];
        if (!sample.subject.empty() || shares[i] <= 0 || shares[i] < least) continue;
        if (best == nullptr ||
            std::chrono::abs(sample.time - near.time) < std::chrono::abs(best->time - near.time))
            best = &sample;
    }
    return best;
}

/// True if the network has seen nothing in a sample.
bool is_blind(const Sample& sample) {
    return cv::mean(sample.subject)[0] < min_mass ||
           subject_outline(sample.subject).certainty < blind_certainty;
}

/// Looks at one sample. Where nothing is seen there, the nearest at which much moves counts in its place.
void look_at(Sample& sample, SaliencyNetwork& network, const Shot& shot, std::vector<Sample>& samples) {
    sample.subject = subject_in(network, sample);
    Sample* other = is_blind(sample) ? busy_sample_near(sample, shot, samples) : nullptr;
    if (other == nullptr) return;
    other->subject = subject_in(network, *other);
    (is_blind(*other) ? other : &sample)->subject.release();
}

/// The looks that a shot of this length is worth.
int wanted_looks(const Shot& shot, const LookPace& pace) {
    return std::min(1 + static_cast<int>(seconds(shot.duration()) / pace.seconds), pace.max);
}

}  // namespace

SubjectLooks::SubjectLooks(const AnalysisSettings& settings, const MediaRecord& film)
    : settings_(settings),
      pace_(settings.is_student ? student_pace : network_pace),
      rate_(std::max(min_rate, static_cast<double>(film.width) * film.height / pace_.pixels)),
      first_{.open = quick_network,
             .is_off = film.kind == MediaKind::photo || settings.saliency_model.empty()},
      spare_{.open = spare_network, .is_off = film.kind == MediaKind::photo || settings.spare_model.empty()} {
}

void SubjectLooks::look(const Shot& shot, std::vector<Sample>& samples) {
    if (samples.empty()) return;
    const int count = first_.is_off ? 0 : affordable(shot);
    if (count > 0) taken_ += look(first_, count, shot, samples);
    const auto is_seen = [](const Sample& sample) { return !sample.subject.empty(); };
    if (!spare_.is_off && std::ranges::none_of(samples, is_seen))
        look(spare_, std::min(wanted_looks(shot, pace_), max_spare), shot, samples);
}

int SubjectLooks::look(Looker& looker, int count, const Shot& shot, std::vector<Sample>& samples) {
    count = std::min(count, static_cast<int>(samples.size()));
    int taken = 0;
    try {
        if (!looker.network) looker.network = looker.open(settings_);
        if (!looker.network) throw std::runtime_error("the model takes no smaller pictures");
        for (int i = 0; i < count; ++i) {
            const double place =
                (i + margin) / (count - 1 + 2 * margin) * static_cast<double>(samples.size());
            Sample& sample = samples[static_cast<std::size_t>(place)];
            if (!sample.subject.empty()) continue;  // it was near one that shows nothing
            look_at(sample, *looker.network, shot, samples);
            ++taken;
        }
    } catch (const std::runtime_error& error) {
        log::warning("films keep their plain regions: {}", error.what());
        looker.is_off = true;
        for (Sample& sample : samples)
            sample.subject.release();
    }
    return taken;
}

int SubjectLooks::affordable(const Shot& shot) const {
    const double earned = pace_.at_once + rate_ * seconds(shot.end);
    return std::min(wanted_looks(shot, pace_), static_cast<int>(earned) - taken_);
}

}  // namespace vitrine::analyzer
