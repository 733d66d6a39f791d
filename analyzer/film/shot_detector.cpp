#include "analyzer/film/shot_detector.hpp"

#include "analyzer/film/transition_detector.hpp"

#include <utility>

namespace vitrine::analyzer {

namespace {

using std::chrono::nanoseconds;

// Shorter stretches in a row, cut to each other, are a montage and shown as one shot.
constexpr std::chrono::milliseconds min_alone{1000};
constexpr std::chrono::seconds max_montage{5};
// A montage so short cannot be taken in: the next shot begins with it, if only a cut is between them.
constexpr std::chrono::milliseconds min_shot{500};
constexpr std::chrono::milliseconds min_shown{250};  // a shorter stretch between transitions belongs to them

}  // namespace

struct ShotDetector::State {
    TransitionDetector transitions;
    std::optional<nanoseconds> first;     // the film's first frame
    std::optional<nanoseconds> begin;     // the begin of the open shot
    std::optional<DetectedShot> montage;  // short stretches that are not given out yet, cut to each other
    bool any = false;                     // a shot was given out

    void close(const Transition& transition, std::vector<DetectedShot>& out);
    void give(const DetectedShot& shot, std::vector<DetectedShot>& out);
    void give_montage(std::vector<DetectedShot>& out);
};

void ShotDetector::State::give(const DetectedShot& shot, std::vector<DetectedShot>& out) {
    out.push_back(shot);
    any = true;
}

void ShotDetector::State::give_montage(std::vector<DetectedShot>& out) {
    if (montage && montage->end - montage->begin >= min_shown) give(*montage, out);
    montage.reset();
}

void ShotDetector::State::close(const Transition& transition, std::vector<DetectedShot>& out) {
    const DetectedShot shot{*begin, transition.begin, transition.kind};
    begin = transition.end;
    if (montage && montage->end != shot.begin) give_montage(out);
    if (shot.end <= shot.begin) return;
    const bool is_short = shot.end - shot.begin < min_alone;
    if (montage && montage->end - montage->begin >= (is_short ? max_montage : min_shot)) give_montage(out);
    if (!montage) montage = shot;
    montage->end = shot.end;
    montage->ends_with = shot.ends_with;
    if (!is_short) give_montage(out);
}

ShotDetector::ShotDetector() : state_(std::make_unique<State>()) {}

ShotDetector::~ShotDetector() = default;

std::vector<DetectedShot> ShotDetector::push(const FilmFrame& frame) {
    if (!state_->begin) state_->first = state_->begin = frame.time;
    std::vector<DetectedShot> shots;
    for (const Transition& transition : state_->transitions.push(features_of(frame)))
        state_->close(transition, shots);
    return shots;
}

std::vector<DetectedShot> ShotDetector::finish(nanoseconds end) {
    std::vector<DetectedShot> shots;
    if (!state_->begin) return shots;
    for (const Transition& transition : state_->transitions.finish(end))
        state_->close(transition, shots);
    if (*state_->begin < end) state_->close({end, end, ShotEnd::end}, shots);
    state_->give_montage(shots);
    if (!shots.empty())
        shots.back().ends_with = shots.back().end == end ? ShotEnd::end : shots.back().ends_with;
    if (!state_->any)
        shots.push_back({*state_->first, end, ShotEnd::end});  // one colour, or too short for anything
    return shots;
}

}  // namespace vitrine::analyzer
