#include "analyzer/film/transition_detector.hpp"

#include "analyzer/film/cut_finder.hpp"
#include "analyzer/film/standing_picture.hpp"
#include "analyzer/film/sudden_change.hpp"

#include <algorithm>
#include <iterator>

namespace vitrine::analyzer {

namespace {

constexpr std::chrono::milliseconds settle{2500};  // longer than a usual wipe, and than a finder may be late
constexpr std::chrono::milliseconds touching{60};  // a cut so near a fade's end is that end

constexpr std::chrono::milliseconds max_plain_flash{400};  // to white or black and back

// Bounds of the share that a dissolve leaves unexplained, see GradualChange.
constexpr double min_dissolve_share = .19;
constexpr double min_dissolve_area = .55;      // a thing that passes, or bars that move in, fill less
constexpr double min_weak_dissolve_area = .8;  // else it is a pan beyond the reach of the search
constexpr double weak_dissolve = .25;          // share
constexpr double min_dissolve_unmoved = .3;
constexpr double min_dissolve_on_way = .43;

bool is_gradual(const Transition& transition) {
    return transition.end > transition.begin;
}

bool are_one(const Transition& a, const Transition& b) {
    if (!is_gradual(a) && !is_gradual(b)) return a.begin == b.begin;
    return a.begin <= b.end + touching && b.begin <= a.end + touching;
}

Transition joined(const Transition& a, const Transition& b) {
    const auto begin =
        is_gradual(a) && is_gradual(b) ? std::min(a.begin, b.begin) : (is_gradual(a) ? a : b).begin;
    const auto end = is_gradual(a) && is_gradual(b) ? std::max(a.end, b.end) : (is_gradual(a) ? a : b).end;
    const bool fades = a.kind == ShotEnd::fade || b.kind == ShotEnd::fade;
    const bool dissolves = a.kind == ShotEnd::dissolve || b.kind == ShotEnd::dissolve;
    return {begin, end, fades ? ShotEnd::fade : dissolves ? ShotEnd::dissolve : ShotEnd::cut};
}

}  // namespace

std::vector<Transition> TransitionDetector::push(const FrameFeatures& frame) {
    window_.push(frame);
    judged_ = std::max(judged_, window_.first());
    while (frame.time - window_.time(judged_) >= cut_horizon)
        judge(judged_++);
    const auto first_open = std::find_if(pending_.begin(), pending_.end(),
                                         [&](const Transition& found) { return !is_settled(found); });
    std::vector<Transition> settled(pending_.begin(), first_open);
    pending_.erase(pending_.begin(), first_open);
    return settled;
}

std::vector<Transition> TransitionDetector::finish(std::chrono::nanoseconds end) {
    while (judged_ < window_.end())
        judge(judged_++);
    if (const auto found = dissolves_.finish()) add_dissolve(*found);
    if (const auto found = fades_.finish(end)) add(*found);
    return std::exchange(pending_, {});
}

void TransitionDetector::judge(std::size_t frame) {
    since_ = std::max(since_, window_.first());
    faded_ = std::max(faded_, window_.first());
    if ((is_cut(window_, frame) || is_sudden_change(window_, frame)) &&
        !is_in_short_dissolve(window_, frame)) {
        add({window_.time(frame), window_.time(frame), ShotEnd::cut});
        since_ = frame;
    }
    if (const auto found = dissolves_.push(window_, frame, since_)) add_dissolve(*found);
    if (const auto found = wipes_.push(window_, frame, faded_)) add(*found);
    if (const auto found = fades_.push(window_, frame, since_); found && !is_flash(*found)) {
        add(*found);
        since_ = std::max(since_, frame);
        faded_ = since_;
    }
}

bool TransitionDetector::is_flash(const Transition& found) const {
    if (found.end - found.begin > max_plain_flash || found.begin <= window_.time(window_.first()))
        return false;
    return !is_new_take(window_, window_.frame_at(found.begin) - 1, window_.frame_at(found.end));
}

bool TransitionDetector::is_dissolve(const Transition& found) const {
    const std::size_t begin = window_.frame_at(found.begin);
    const std::size_t end = window_.frame_at(found.end);
    const GradualChange change = gradual_change(window_, begin, end);
    const double min_area = change.share < weak_dissolve ? min_weak_dissolve_area : min_dissolve_area;
    return change.share > min_dissolve_share && change.area > min_area &&
           change.unmoved > min_dissolve_unmoved && change.on_way > min_dissolve_on_way &&
           is_new_take(window_, begin, end);
}

void TransitionDetector::add_dissolve(const Transition& found) {
    if (!is_dissolve(found)) return;
    const Transition dissolve = without_standing(window_, found);
    if (is_gradual(dissolve)) add(dissolve);  // else it is the lit end of a fade that is found by itself
}

void TransitionDetector::add(const Transition& found) {
    Transition whole = found;
    std::erase_if(pending_, [&](const Transition& other) {
        if (!are_one(whole, other)) return false;
        whole = joined(whole, other);
        return true;
    });
    const auto later = [&](const Transition& other) { return other.begin > whole.begin; };
    pending_.insert(std::find_if(pending_.begin(), pending_.end(), later), whole);
}

bool TransitionDetector::is_settled(const Transition& found) const {
    const auto now = window_.time(window_.end() - 1);
    for (const auto& open : {dissolves_.open_since(), fades_.open_since()})
        if (open && *open <= found.end + touching) return false;
    return now - found.end > settle;
}

}  // namespace vitrine::analyzer
