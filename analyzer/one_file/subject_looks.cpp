#include "analyzer/one_file/subject_looks.hpp"

#include "analyzer/one_file/subject_network.hpp"
#include "base/system/log.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace vitrine::analyzer {
namespace {

// A look of the large network at 160 px takes about .13 s of processor time, as long as decoding 16 pictures
// of 1080p or 70 of 720p. So its looks add an eighth to what decoding of 1080p costs, and a quarter to that
// of 720p. The student takes a fifth of that time; more looks than these made regions larger and no better.
constexpr LookPace network_pace{.pixels = 9e6, .seconds = 3, .at_once = 2, .max = 6};
constexpr LookPace student_pace{.pixels = 4.5e6, .seconds = 2, .at_once = 4, .max = 8};
constexpr double min_rate = 0.1;

double seconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

}  // namespace

SubjectLooks::SubjectLooks(const AnalysisSettings& settings, const MediaRecord& film)
    : settings_(settings),
      pace_(settings.is_student ? student_pace : network_pace),
      rate_(std::max(min_rate, static_cast<double>(film.width) * film.height / pace_.pixels)),
      is_off_(film.kind == MediaKind::photo || settings.saliency_model.empty()) {}

void SubjectLooks::look(const Shot& shot, std::vector<Sample>& samples) {
    if (is_off_ || samples.empty()) return;
    const int count = std::min(affordable(shot), static_cast<int>(samples.size()));
    if (count <= 0 || !open()) return;
    taken_ += count;
    try {
        for (int i = 0; i < count; ++i) {
            const double place = (i + 0.5) / count * static_cast<double>(samples.size());
            Sample& sample = samples[static_cast<std::size_t>(place)];
            sample.subject = subject_in(*network_, sample);
        }
    } catch (const std::runtime_error& error) {
        log::warning("films keep their plain regions: {}", error.what());
        is_off_ = true;
        for (Sample& sample : samples)
            sample.subject.release();
    }
}

int SubjectLooks::affordable(const Shot& shot) const {
    const double earned = pace_.at_once + rate_ * seconds(shot.end);
    const int wanted = 1 + static_cast<int>(seconds(shot.duration()) / pace_.seconds);
    return std::min({wanted, pace_.max, static_cast<int>(earned) - taken_});
}

bool SubjectLooks::open() {
    if (network_) return true;
    try {
        network_ = quick_network(settings_);
        if (!network_) throw std::runtime_error("the model takes no smaller pictures");
    } catch (const std::runtime_error& error) {
        log::warning("films keep their plain regions: {}", error.what());
        is_off_ = true;
    }
    return !is_off_;
}

}  // namespace vitrine::analyzer
