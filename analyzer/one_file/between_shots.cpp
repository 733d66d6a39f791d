#include "analyzer/one_file/between_shots.hpp"

#include <algorithm>
#include <cstddef>

namespace vitrine::analyzer {

namespace {

using std::chrono::nanoseconds;

constexpr std::size_t max_stretches = 10'000;          // of one kind
constexpr std::chrono::milliseconds min_stretch{200};  // a shorter one counts to its transition

/// Puts the parts of a gap that `known` tells into the list, and the rest as transitions.
void split_gap(const Stretch& gap, const std::vector<Stretch>& known, std::vector<Stretch>& out) {
    nanoseconds at = gap.begin;
    for (const Stretch& stretch : known) {
        const nanoseconds begin = std::max(at, stretch.begin);
        const nanoseconds end = std::min(gap.end, stretch.end);
        if (end - begin < min_stretch) continue;
        if (at < begin) out.push_back({at, begin, StretchKind::transition});
        out.push_back({begin, end, stretch.kind});
        at = end;
    }
    if (at < gap.end) out.push_back({at, gap.end, StretchKind::transition});
}

}  // namespace

void UnshownTimes::add_sample(nanoseconds time, bool is_plain) {
    if (is_open_) plain_.back().end = time;
    const bool opens = is_plain && !is_open_ && plain_.size() < max_stretches;
    if (opens) plain_.push_back({time, time, StretchKind::plain});
    is_open_ = opens || (is_plain && is_open_);
}

void UnshownTimes::add_empty(nanoseconds begin, nanoseconds end) {
    if (empty_.size() < max_stretches) empty_.push_back({begin, end, StretchKind::empty});
}

std::vector<Stretch> UnshownTimes::between(const MediaRecord& record) const {
    std::vector<Stretch> known = plain_;
    if (is_open_) known.back().end = record.duration;
    known.insert(known.end(), empty_.begin(), empty_.end());
    std::ranges::stable_sort(known, {}, &Stretch::begin);
    std::vector<Stretch> result;
    nanoseconds at{0};
    for (const Shot& shot : record.shots) {
        if (at < shot.begin) split_gap({at, shot.begin}, known, result);
        at = std::max(at, shot.end);
    }
    if (at < record.duration) split_gap({at, record.duration}, known, result);
    return result;
}

}  // namespace vitrine::analyzer
