#include "analyzer/tapestry/synthesis/keyframes.hpp"

#include "analyzer/tapestry/synthesis/medoids.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <queue>

namespace vitrine::analyzer {

namespace {

constexpr int max_swap_rounds = 30;
constexpr int small_gap = 48;             // frames; all pairs of a gap so small are tried
constexpr double min_improvement = 1e-6;  // share of far() by which a swap must lower the cost

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

/// One level: adds keyframes to those of the level before.
class Level {
  public:
    Level(const Affinity& costs, Medoids& medoids, bool keeps_rows)
        : costs_(costs), medoids_(medoids), is_frozen_(static_cast<std::size_t>(costs.frames()), false) {
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
    void add_singles(int wanted) {
        add_greedily(
            costs_.frames(), wanted,
            [&](int frame) { return medoids_.contains(frame) ? -1.0 : medoids_.gain(frame); },
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
                return pair.gain;
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
        if (last) medoids_.add(*last);
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
            if (medoids_.contains(frame)) continue;
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
                if (!medoids_.contains(frame)) best = std::max(best, best_with(frame, frame + 1, gap.last));
            return best;
        }
        const std::optional<int> frame = best_single(gap);
        return frame ? best_with(*frame, gap.first, gap.last) : Pair{};
    }

    Pair best_with(int a, int first, int last) const {
        Pair best;
        const double gain = medoids_.gain(a);
        for (int b = first; b < last; ++b) {
            if (medoids_.contains(b) || b == a) continue;
            best = std::max(best, {.gain = gain + medoids_.gain_after(b, a), .a = a, .b = b});
        }
        return best;
    }

    bool swap_in(int in, const Gap& gap) {
        if (medoids_.contains(in)) return false;
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
        if (best < 0) return false;
        medoids_.swap(best, in);
        return true;
    }

    const Affinity& costs_;  // both outlive the level
    Medoids& medoids_;
    std::vector<bool> is_frozen_;
    std::vector<Gap> gaps_;
    bool is_paired_ = false;
    std::vector<double> changes_;
};

}  // namespace

std::vector<Keyframes> keyframe_levels(const Affinity& costs, const KeyframeSettings& settings) {
    Medoids medoids(costs);
    Level coarsest(costs, medoids, settings.keeps_rows);
    coarsest.add(std::min(settings.first, costs.frames()));
    coarsest.improve();
    return refined_levels(costs, medoids.sorted(), settings);
}

std::vector<Keyframes> refined_levels(const Affinity& costs, Keyframes coarsest,
                                      const KeyframeSettings& settings) {
    Medoids medoids(costs);
    for (const int frame : coarsest)
        medoids.add(frame);
    std::vector<Keyframes> levels{std::move(coarsest)};
    while (static_cast<int>(levels.size()) < settings.max_levels) {
        const int before = static_cast<int>(levels.back().size());
        Level level(costs, medoids, settings.keeps_rows);
        level.add(std::min(before * settings.growth, costs.frames()) - before);
        level.improve();
        if (static_cast<int>(medoids.sorted().size()) == before) break;
        levels.push_back(medoids.sorted());
    }
    return levels;
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
