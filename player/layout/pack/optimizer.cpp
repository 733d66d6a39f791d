#include "player/layout/pack/optimizer.hpp"

#include "player/layout/pack/compaction.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double rounding = 1e-6;          // of the growth
constexpr double loosening = 0.01;         // of the growth, before a disturbed arrangement is separated
constexpr double least_promising = 0.7;    // of the best growth: what overlaps more is given up
constexpr double tolerated_loss = 0.002;   // of the growth, from which the search still goes on
constexpr std::size_t trials_astray = 50;  // without a better one, then back to the best
constexpr std::size_t vain_trials_an_item = 300;  // in a row: then the search has converged
constexpr std::size_t least_vain_trials_an_item = 60;
constexpr std::int64_t vain_effort = 2;     // times what led to the last gain: then it has converged too
constexpr double relocations = 0.3;         // of the disturbances; the others are exchanges
constexpr std::size_t most_compacted = 48;  // items; programs of more take too long
constexpr double growing_step = 0.006;      // of the growth, where nothing is compacted
constexpr int exploring_patience = 4;       // rounds without less overlap
constexpr int growing_patience = 8;
constexpr double calm_step = 0.008;  // of the growth, at first
constexpr SeparationStyle roaming{.finest_step = 1};

#ifdef VITRINE_CHECKS_STATES
constexpr bool checks_states = true;
#else
constexpr bool checks_states = false;
#endif

/// Keeps the best arrangement.
class Best {
  public:
    Best(const Ground& ground, Contacts& contacts, const Arrangement& start, const OnBetter& on_better)
        : ground_(ground),
          contacts_(contacts),
          on_better_(on_better),
          limit_(final_growth(ground)),
          arrangement_(start) {
        take(start);
    }

    const Arrangement& arrangement() const { return arrangement_; }

    bool is_final() const { return arrangement_.growth >= limit_ * (1 - 1e-9); }

    double stepped_up(double step) const { return std::min(limit_, arrangement_.growth * (1 + step)); }

    /// Grows what was found where it stands. @pre found is free, but for rounding
    /// @return whether it is better
    bool take(const Arrangement& found) {
        constexpr double reach = 1.05;
        const double growth = greatest_growth(ground_, found, contacts_, found.growth * (1 - rounding),
                                              std::min(limit_, found.growth * reach));
        if (growth <= arrangement_.growth) return false;
        arrangement_ = {found.places, growth};
        if constexpr (checks_states) assert(is_exactly_free(ground_, arrangement_));
        if (on_better_) on_better_(arrangement_);
        return true;
    }

  private:
    const Ground& ground_;      // outlives this
    const Contacts& contacts_;  // outlives this
    const OnBetter& on_better_;
    double limit_;
    Arrangement arrangement_;
};

/// Lets two items change places, or one go anywhere: what separation by itself hardly ever does.
void disturb(const Ground& ground, Arrangement& arrangement, Random& random) {
    std::vector<std::size_t> movable;
    for (std::size_t i = 0; i < ground.size(); ++i)
        if (!ground.pinned[i]) movable.push_back(i);
    if (movable.empty()) return;
    const std::size_t a = movable[uniform_index(random, movable.size())];
    const std::size_t b = movable[uniform_index(random, movable.size())];
    if (a == b || uniform(random) < relocations)
        arrangement.places[a] = random_place(ground.range(a, arrangement.growth), random);
    else
        std::swap(arrangement.places[a], arrangement.places[b]);
}

/// From one local maximum to another: disturbs, separates roughly, shrinks what still overlaps, compacts.
void explore(const Ground& ground, Contacts& contacts, Best& best, Random& random, Effort& effort) {
    Separation separation(ground, contacts, random);
    best.take(compacted(ground, best.arrangement(), contacts, effort));
    Arrangement current = best.arrangement();
    std::size_t vain = 0;  // trials in a row
    const std::int64_t begin = effort.left();
    std::int64_t gained = begin;  // what was left at the last gain
    const auto has_converged = [&] {
        if (vain < least_vain_trials_an_item * ground.size()) return false;
        return vain >= vain_trials_an_item * ground.size() ||
               gained - effort.left() >= vain_effort * (begin - gained);
    };
    while (!has_converged() && !effort.is_spent() && !best.is_final()) {
        if (++vain % trials_astray == 0) current = best.arrangement();
        Arrangement trial = current;
        trial.growth *= 1 - loosening;
        disturb(ground, trial, random);
        separation.run(trial, roaming, effort, exploring_patience);
        const double least = best.arrangement().growth * least_promising;
        trial.growth = greatest_growth(ground, trial, contacts, least, trial.growth);
        if (trial.growth == 0) continue;
        trial = compacted(ground, trial, contacts, effort);
        if (best.take(trial)) {
            vain = 0;
            gained = effort.left();
        }
        if (trial.growth > current.growth * (1 - tolerated_loss)) current = trial;
    }
}

/// Of many items: grows all by steps and separates what then overlaps.
void grow(const Ground& ground, Contacts& contacts, Best& best, Random& random, Effort& effort) {
    constexpr int most_halvings = 6;
    Separation separation(ground, contacts, random);
    double step = growing_step;
    int failures = 0;
    for (int halvings = 0; halvings < most_halvings && !effort.is_spent() && !best.is_final();) {
        Arrangement trial = best.arrangement();
        trial.growth = best.stepped_up(step);
        if (separation.run(trial, roaming, effort, growing_patience) && best.take(trial)) continue;
        if (++failures % 2 != 0) continue;
        step /= 2;
        ++halvings;
    }
}

}  // namespace

Arrangement densest(const Ground& ground, const Arrangement& start, Random& random, Effort& effort,
                    const OnBetter& on_better) {
    if (ground.size() == 0 || final_growth(ground) == 0) return start;
    Contacts contacts(ground.shapes, ground.clearance);
    Best best(ground, contacts, start, on_better);
    (ground.size() <= most_compacted ? explore : grow)(ground, contacts, best, random, effort);
    return best.arrangement();
}

Arrangement calmly_grown(const Ground& ground, const Arrangement& start, const std::vector<Vec2>& homes,
                         Random& random, Effort& effort) {
    constexpr int failures_allowed = 3;
    if (ground.size() == 0 || final_growth(ground) == 0) return start;
    const OnBetter nobody;
    Contacts contacts(ground.shapes, ground.clearance);
    Best best(ground, contacts, start, nobody);
    Separation separation(ground, contacts, random);
    const SeparationStyle style{.roams = false, .homes = homes, .pull = 0.05};
    double step = calm_step;
    int failures = 0;
    while (!effort.is_spent() && !best.is_final() && failures < failures_allowed) {
        Arrangement trial = best.arrangement();
        trial.growth = best.stepped_up(step);
        if (separation.run(trial, style, effort, growing_patience)) {
            if (best.take(trial)) continue;
        }
        ++failures;
        step /= 2;
    }
    return best.arrangement();
}

void pull_home(const Ground& ground, Arrangement& arrangement, const std::vector<Vec2>& homes,
               Contacts& contacts) {
    constexpr int rounds = 3;
    constexpr int halvings = 10;
    contacts.set_scales(scales_at(ground, arrangement.growth));
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < ground.size(); ++i) {
            if (ground.pinned[i]) continue;
            const Vec2 here = arrangement.places[i];
            const Vec2 home = held(homes[i], ground.range(i, arrangement.growth));
            double share = 1;  // of the way home; halved until the place is clear
            for (int k = 0; k < halvings; ++k, share /= 2)
                if (may_stand(ground, contacts, arrangement, i, here + (home - here) * share)) {
                    arrangement.places[i] = here + (home - here) * share;
                    break;
                }
        }
}

}  // namespace vitrine::player
