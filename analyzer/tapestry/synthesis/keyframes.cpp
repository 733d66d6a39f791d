#include "analyzer/tapestry/synthesis/keyframes.hpp"

#include "analyzer/tapestry/synthesis/frame_fitness.hpp"
#include "analyzer/tapestry/synthesis/medoids.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <queue>
#include <utility>

namespace vitrine::analyzer {

namespace {

constexpr int max_swap_rounds = 30;
constexpr int small_gap = 48;             // frames; all pairs of a gap so small are tried
constexpr double min_improvement = 1e-6;  // share of far() by which a swap must lower the cost
constexpr double gain_step = 0.25;        // of the gain that each finer level asks for
constexpr double difference_step = 0.5;   // of the difference to the neighbours
constexpr int finest = 3;                 // steps; the last asks for differences of 2.5 grey levels
constexpr double min_growth = 4.0 / 3;    // of a level over the one before

/// The frames between two frozen keyframes: [first, last) without them.
struct Gap {
    int first = 0;
    int last = 0;
};

/// A frame or pair that could be added next. Its gain is an upper bound once others were added.
struct Proposal {
    double gain = 0;
    int place = 0;          // a frame or the number of a gap
    std::size_t round = 0;  // number of additions when the gain was computed

    bool operator<(const Proposal& other) const {
        return gain != other.gain ? gain < other.gain : place > other.place;
    }
};

/// Adds the best of many proposals again and again. An outdated gain is computed anew only where it leads.
/// @param gain  the gain of a place now; less than 0 where nothing can be added any more
/// @param add   adds at a place; returns the number of keyframes added
void add_greedily(int places, int wanted, const std::function<double(int)>& gain,
                  const std::function<int(int)>& add) {
    std::priority_queue<Proposal> queue;
    for (int place = 0; place < places; ++place)
        queue.push({.gain = gain(place), .place = place});
    for (std::size_t round = 0; wanted > 0 && !queue.empty();) {
        Proposal best = queue.top();
        queue.pop();
        if (best.round != round) {
            best = {.gain = gain(best.place), .place = best.place, .round = round};
            if (best.gain >= 0) queue.push(best);
        } else if (best.gain >= 0) {
            wanted -= add(best.place);
            ++round;
            queue.push(best);
        }
    }
}

/// Tells which frames may become keyframes of one level.
class Gate {
  public:
    /// @param fineness  number of the level among the levels tried
    Gate(const std::optional<KeyframeRules>& rules, int fineness) : rules_(rules) {
        if (!rules) return;
        min_gain_ = rules->min_gain * std::pow(gain_step, fineness);
        min_difference_ = rules->min_difference * std::pow(difference_step, fineness);
    }

    double min_gain() const { return min_gain_; }

    bool is_fit(int frame) const { return !rules_ || rules_->fit[static_cast<std::size_t>(frame)]; }

    bool are_different(int a, int b) const {
        return !rules_ || difference(rules_->frames[static_cast<std::size_t>(a)],
                                     rules_->frames[static_cast<std::size_t>(b)]) >= min_difference_;
    }

    /// Tells if a frame may become a keyframe beside others. @param out  a keyframe that goes; -1: none does
    bool admits(int frame, const std::vector<int>& keyframes, int out = -1) const {
        if (!rules_) return true;
        if (!is_fit(frame)) return false;
        const auto after = std::ranges::lower_bound(keyframes, frame);
        auto next = after;
        if (next != keyframes.end() && *next == out) ++next;
        auto before = after;
        if (before != keyframes.begin() && *(before - 1) == out) --before;
        const int left = before == keyframes.begin() ? -1 : *(before - 1);
        const int right = next == keyframes.end() ? -1 : *next;
        if (is_first_of_take(frame, left, right)) return true;
        return (left < 0 || are_different(frame, left)) && (right < 0 || are_different(frame, right));
    }

  private:
    bool is_first_of_take(int frame, int left, int right) const {
        const int take = take_of(frame);
        return take >= 0 && (left < 0 || take_of(left) != take) && (right < 0 || take_of(right) != take);
    }

    int take_of(int frame) const { return rules_->takes[static_cast<std::size_t>(frame)]; }

    const std::optional<KeyframeRules>& rules_;  // outlives this
    double min_gain_ = 0;
    double min_difference_ = 0;
};

/// One level: adds keyframes to those of the level before.
class Level {
  public:
    Level(const Affinity& costs, Medoids& medoids, const Gate& gate, bool keeps_rows)
        : costs_(costs),
          medoids_(medoids),
          gate_(gate),
          is_frozen_(static_cast<std::size_t>(costs.frames()), false) {
        for (const int frame : medoids.sorted())
            is_frozen_[static_cast<std::size_t>(frame)] = true;
        if (!keeps_rows || medoids.sorted().empty()) {
            gaps_.push_back({0, costs.frames()});
            return;
        }
        is_paired_ = true;
        int first = 0;
        for (const int frame : medoids.sorted()) {
            gaps_.push_back({first, frame});
            first = frame + 1;
        }
        gaps_.push_back({first, costs.frames()});
    }

    void add(int wanted) {
        if (is_paired_)
            add_pairs(wanted);
        else
            add_singles(wanted);
    }

    /// Swaps new keyframes against others of their gap until no swap lowers the cost.
    void improve() {
        for (int round = 0; round < max_swap_rounds; ++round) {
            bool is_better = false;
            for (const Gap& gap : gaps_)
                for (int in = gap.first; in < gap.last; ++in)
                    is_better |= swap_in(in, gap);
            if (!is_better) return;
        }
    }

  private:
    bool may_add(int frame) const {
        return !medoids_.contains(frame) && gate_.admits(frame, medoids_.sorted());
    }

    /// The gain of some keyframes; less than 0 where it is too little.
    double worthy(double gain, int keyframes) const {
        return gain >= keyframes * gate_.min_gain() ? gain : -1;
    }

    void add_singles(int wanted) {
        add_greedily(
            costs_.frames(), wanted,
            [&](int frame) { return may_add(frame) ? worthy(medoids_.gain(frame), 1) : -1.0; },
            [&](int frame) {
                medoids_.add(frame);
                return 1;
            });
    }

    void add_pairs(int wanted) {
        if (wanted % 2 != 0) add_last();
        std::vector<Pair> pairs(gaps_.size());
        int missing = wanted / 2 * 2;
        add_greedily(
            static_cast<int>(gaps_.size()), missing,
            [&](int gap) {
                Pair& pair = pairs[static_cast<std::size_t>(gap)];
                pair = best_pair(gaps_[static_cast<std::size_t>(gap)]);
                return worthy(pair.gain, 2);
            },
            [&](int gap) {
                const Pair& pair = pairs[static_cast<std::size_t>(gap)];
                medoids_.add(pair.a);
                medoids_.add(pair.b);
                missing -= 2;
                return 2;
            });
        if (missing > 0) add_last();
    }

    /// Adds a single keyframe behind all others, where it moves none of them to the other row.
    void add_last() {
        const std::optional<int> last = best_single(gaps_.back());
        if (last && worthy(medoids_.gain(*last), 1) >= 0) medoids_.add(*last);
    }

    struct Pair {
        double gain = -1;
        int a = -1;
        int b = -1;

        bool operator<(const Pair& other) const { return gain < other.gain; }
    };

    std::optional<int> best_single(const Gap& gap) const {
        std::optional<int> best;
        double most = -1;
        for (int frame = gap.first; frame < gap.last; ++frame) {
            if (!may_add(frame)) continue;
            const double gain = medoids_.gain(frame);
            if (gain <= most) continue;
            most = gain;
            best = frame;
        }
        return best;
    }

    /// The best of all pairs in a small gap; in a large one the best frame with the best second frame.
    Pair best_pair(const Gap& gap) const {
        if (gap.last - gap.first <= small_gap) {
            Pair best;
            for (int frame = gap.first; frame < gap.last; ++frame)
                if (may_add(frame)) best = std::max(best, best_with(frame, frame + 1, gap.last));
            return best;
        }
        const std::optional<int> frame = best_single(gap);
        return frame ? best_with(*frame, gap.first, gap.last) : Pair{};
    }

    Pair best_with(int a, int first, int last) const {
        Pair best;
        const double gain = medoids_.gain(a);
        for (int b = first; b < last; ++b) {
            if (b == a || !may_add(b) || !gate_.are_different(a, b)) continue;
            best = std::max(best, {.gain = gain + medoids_.gain_after(b, a), .a = a, .b = b});
        }
        return best;
    }

    bool swap_in(int in, const Gap& gap) {
        if (medoids_.contains(in) || !gate_.is_fit(in)) return false;
        medoids_.swap_changes(in, gap.first, gap.last, changes_);
        int best = -1;
        double least = -min_improvement * costs_.far();
        const auto& sorted = medoids_.sorted();
        for (auto out = std::ranges::lower_bound(sorted, gap.first); out != sorted.end() && *out < gap.last;
             ++out) {
            const double change = changes_[static_cast<std::size_t>(*out - gap.first)];
            if (is_frozen_[static_cast<std::size_t>(*out)] || change >= least) continue;
            least = change;
            best = *out;
        }
        if (best < 0 || !gate_.admits(in, medoids_.sorted(), best)) return false;
        medoids_.swap(best, in);
        return true;
    }

    const Affinity& costs_;  // all outlive the level
    Medoids& medoids_;
    const Gate& gate_;
    std::vector<bool> is_frozen_;
    std::vector<Gap> gaps_;
    bool is_paired_ = false;
    std::vector<double> changes_;
};

/// The costs with rules: frames that are not fit need not be shown, and a frame of another take shows none
/// well.
Affinity told_costs(Affinity told, const std::optional<KeyframeRules>& rules) {
    if (!rules) return told;
    const auto of_take = static_cast<float>(rules->min_gain);
    for (int j = 0; j < told.frames(); ++j) {
        for (int i = told.first(j); i < told.last(j); ++i) {
            const int take = rules->takes[static_cast<std::size_t>(i)];
            const bool is_other = take >= 0 && take != rules->takes[static_cast<std::size_t>(j)];
            if (!rules->fit[static_cast<std::size_t>(i)])
                told.set(i, j, 0);
            else if (is_other)
                told.set(i, j, told.at(i, j) + of_take);
        }
    }
    told.set_far(told.far() + of_take);
    return told;
}

Keyframes coarsest_of(const Affinity& costs, const KeyframeSettings& settings, int count) {
    Medoids medoids(costs);
    for (const int frame : settings.chosen)
        medoids.add(frame);
    const Gate gate(settings.rules, 0);
    constexpr bool is_paired = false;  // there are no rows yet to be kept
    Level level(costs, medoids, gate, is_paired);
    level.add(std::min(count, costs.frames()) - static_cast<int>(settings.chosen.size()));
    level.improve();
    return medoids.sorted();
}

std::vector<Keyframes> finer_levels(const Affinity& costs, Keyframes coarsest,
                                    const KeyframeSettings& settings) {
    Medoids medoids(costs);
    for (const int frame : coarsest)
        medoids.add(frame);
    std::vector<Keyframes> levels{std::move(coarsest)};
    const int max_fineness = settings.rules ? finest : 0;
    for (int fineness = 0; static_cast<int>(levels.size()) < settings.max_levels;) {
        const int before = static_cast<int>(levels.back().size());
        const int wanted = std::min(before * settings.growth, costs.frames());
        const Gate gate(settings.rules, fineness);
        Level level(costs, medoids, gate, settings.keeps_rows);
        level.add(wanted - static_cast<int>(medoids.sorted().size()));
        level.improve();
        const auto now = static_cast<int>(medoids.sorted().size());
        if (now > before && (!settings.rules || now >= min_growth * before))
            levels.push_back(medoids.sorted());
        const bool is_all = settings.rules ? now < wanted : now == before;
        if (is_all && ++fineness > max_fineness) break;
        if (wanted == before) break;
    }
    return levels;
}

}  // namespace

std::vector<Keyframes> keyframe_levels(Affinity costs, const KeyframeSettings& settings) {
    const Affinity told = told_costs(std::move(costs), settings.rules);
    Keyframes coarsest = coarsest_of(told, settings, settings.rules ? settings.max_first : settings.first);
    if (settings.rules && static_cast<int>(coarsest.size()) >= settings.max_first)
        coarsest = coarsest_of(told, settings, settings.first);
    if (!settings.rules) return finer_levels(told, std::move(coarsest), settings);
    KeyframeSettings more = settings;
    more.max_levels += settings.min_first;  // so many at most are left out, as each has one keyframe more
    std::vector<Keyframes> levels = finer_levels(told, std::move(coarsest), more);
    const auto fills = [&](const Keyframes& level) {
        return static_cast<int>(level.size()) >= settings.min_first;
    };
    levels.erase(levels.begin(), std::find_if(levels.begin(), levels.end() - 1, fills));
    levels.resize(std::min(levels.size(), static_cast<std::size_t>(settings.max_levels)));
    return levels;
}

std::vector<Keyframes> refined_levels(Affinity costs, Keyframes coarsest, const KeyframeSettings& settings) {
    return finer_levels(told_costs(std::move(costs), settings.rules), std::move(coarsest), settings);
}

Keyframes uniform_keyframes(int frames, int count) {
    const std::int64_t taken = std::min(frames, count);
    Keyframes keyframes;
    keyframes.reserve(static_cast<std::size_t>(taken));
    for (std::int64_t k = 0; k < taken; ++k)
        keyframes.push_back(static_cast<int>((2 * k + 1) * frames / (2 * taken)));
    return keyframes;
}

Keyframes keyframes_at(std::span<const FrameSignature> frames,
                       std::span<const std::chrono::nanoseconds> times) {
    Keyframes keyframes;
    for (const auto time : times) {
        const auto after = std::ranges::lower_bound(frames, time, {}, &FrameSignature::time);
        auto nearest = after;
        if (after == frames.end() ||
            (after != frames.begin() && time - (after - 1)->time <= after->time - time))
            --nearest;
        keyframes.push_back(static_cast<int>(nearest - frames.begin()));
    }
    std::ranges::sort(keyframes);
    keyframes.erase(std::unique(keyframes.begin(), keyframes.end()), keyframes.end());
    return keyframes;
}

}  // namespace vitrine::analyzer
