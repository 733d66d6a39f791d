#include "player/layout/pack/optimizer.hpp"

#include "player/layout/pack/compaction.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double rounding = 1e-6;          // share of the growth
constexpr double loosening = 0.01;         // share of the growth taken off before a separation
constexpr double min_promising = 0.7;      // share of the best growth; a trial is given up below it
constexpr double tolerated_loss = 0.002;   // share of the growth; worse trials are dropped
constexpr std::size_t trials_astray = 50;  // trials without a better one, then the search returns to the best
constexpr std::size_t vain_trials_an_item = 300;  // in a row, per item: then the search has converged
constexpr std::size_t min_vain_trials_an_item = 60;
constexpr std::int64_t vain_share = 2;  // times the moves up to the last gain: then it has converged, too
constexpr double relocations = 0.3;  // share of the disturbances that move one item; the others exchange two
constexpr std::size_t max_compacted = 48;  // items; with more, the programs take too long
constexpr double growing_step = 0.006;     // share of the growth in one step, without compaction
constexpr int exploring_patience = 4;      // rounds of separation without less overlap
constexpr int growing_patience = 8;
constexpr double calm_step = 0.008;  // share of the growth in the first step
constexpr SeparationStyle roaming{.finest_step = 1};

#ifdef VITRINE_CHECKS_STATES
constexpr bool checks_states = true;
#else
constexpr bool checks_states = false;
#endif

/// Keeps the best arrangement.
class BestArrangement {
  public:
    BestArrangement(const PackingProblem& problem, Contacts& contacts, const Arrangement& start,
                    const OnBetter& on_better)
        : problem_(problem),
          contacts_(contacts),
          on_better_(on_better),
          limit_(final_growth(problem)),
          arrangement_(start) {
        offer(start);
    }

    const Arrangement& arrangement() const { return arrangement_; }

    bool is_final() const { return arrangement_.growth >= limit_ * (1 - 1e-9); }

    double stepped_up(double step) const { return std::min(limit_, arrangement_.growth * (1 + step)); }

    /// Grows an arrangement at its places, and keeps it if it is better. @pre found is free, but for rounding
    /// @return true: it is better
    bool offer(const Arrangement& found) {
        constexpr double reach = 1.05;
        const double growth = max_free_growth(problem_, found, contacts_, found.growth * (1 - rounding),
                                              std::min(limit_, found.growth * reach));
        if (growth <= arrangement_.growth) return false;
        arrangement_ = {found.places, growth};
        if constexpr (checks_states) assert(is_exactly_free(problem_, arrangement_));
        if (on_better_) on_better_(arrangement_);
        return true;
    }

  private:
    const PackingProblem& problem_;  // outlives this
    const Contacts& contacts_;       // outlives this
    const OnBetter& on_better_;
    double limit_;
    Arrangement arrangement_;
};

/// Exchanges two items, or moves one anywhere: separation alone rarely does that.
void disturb(const PackingProblem& problem, Arrangement& arrangement, Random& random) {
    std::vector<std::size_t> movable;
    for (std::size_t i = 0; i < problem.size(); ++i)
        if (!problem.pinned[i]) movable.push_back(i);
    if (movable.empty()) return;
    const std::size_t a = movable[uniform_index(random, movable.size())];
    const std::size_t b = movable[uniform_index(random, movable.size())];
    if (a == b || uniform(random) < relocations)
        arrangement.places[a] = random_place(problem.place_range(a, arrangement.growth), random);
    else
        std::swap(arrangement.places[a], arrangement.places[b]);
}

/// Goes from one local maximum to another: disturbs, separates roughly, shrinks what still overlaps,
/// compacts.
void explore(const PackingProblem& problem, Contacts& contacts, BestArrangement& best, Random& random,
             SearchBudget& budget) {
    Separation separation(problem, contacts, random);
    best.offer(compacted(problem, best.arrangement(), contacts, budget));
    Arrangement current = best.arrangement();
    std::size_t vain = 0;  // trials in a row without a gain
    const std::int64_t begin = budget.left();
    std::int64_t gained = begin;  // budget left at the last gain
    const auto has_converged = [&] {
        if (vain < min_vain_trials_an_item * problem.size()) return false;
        return vain >= vain_trials_an_item * problem.size() ||
               gained - budget.left() >= vain_share * (begin - gained);
    };
    while (!has_converged() && !budget.is_spent() && !best.is_final()) {
        if (++vain % trials_astray == 0) current = best.arrangement();
        Arrangement trial = current;
        trial.growth *= 1 - loosening;
        disturb(problem, trial, random);
        separation.run(trial, roaming, budget, exploring_patience);
        const double min_growth = best.arrangement().growth * min_promising;
        trial.growth = max_free_growth(problem, trial, contacts, min_growth, trial.growth);
        if (trial.growth == 0) continue;
        trial = compacted(problem, trial, contacts, budget);
        if (best.offer(trial)) {
            vain = 0;
            gained = budget.left();
        }
        if (trial.growth > current.growth * (1 - tolerated_loss)) current = trial;
    }
}

/// For many items: grows all in steps and separates the items that then overlap.
void grow(const PackingProblem& problem, Contacts& contacts, BestArrangement& best, Random& random,
          SearchBudget& budget) {
    constexpr int max_halvings = 6;
    Separation separation(problem, contacts, random);
    double step = growing_step;
    int failures = 0;
    for (int halvings = 0; halvings < max_halvings && !budget.is_spent() && !best.is_final();) {
        Arrangement trial = best.arrangement();
        trial.growth = best.stepped_up(step);
        if (separation.run(trial, roaming, budget, growing_patience) && best.offer(trial)) continue;
        if (++failures % 2 != 0) continue;
        step /= 2;
        ++halvings;
    }
}

}  // namespace

Arrangement densest_arrangement(const PackingProblem& problem, const Arrangement& start, Random& random,
                                SearchBudget& budget, const OnBetter& on_better) {
    if (problem.size() == 0 || final_growth(problem) == 0) return start;
    Contacts contacts(problem.shapes, problem.clearance);
    BestArrangement best(problem, contacts, start, on_better);
    (problem.size() <= max_compacted ? explore : grow)(problem, contacts, best, random, budget);
    return best.arrangement();
}

SeparationStyle calm_style(const std::vector<Vec2>& homes) {
    return {.roams = false, .homes = homes, .pull = 0.05};
}

Arrangement calmly_grown(const PackingProblem& problem, const Arrangement& start,
                         const std::vector<Vec2>& homes, Random& random, SearchBudget& budget) {
    constexpr int failures_allowed = 3;
    if (problem.size() == 0 || final_growth(problem) == 0) return start;
    const OnBetter nobody;
    Contacts contacts(problem.shapes, problem.clearance);
    BestArrangement best(problem, contacts, start, nobody);
    Separation separation(problem, contacts, random);
    const SeparationStyle style = calm_style(homes);
    double step = calm_step;
    int failures = 0;
    while (!budget.is_spent() && !best.is_final() && failures < failures_allowed) {
        Arrangement trial = best.arrangement();
        trial.growth = best.stepped_up(step);
        if (separation.run(trial, style, budget, growing_patience)) {
            if (best.offer(trial)) continue;
        }
        ++failures;
        step /= 2;
    }
    return best.arrangement();
}

void pull_home(const PackingProblem& problem, Arrangement& arrangement, const std::vector<Vec2>& homes,
               Contacts& contacts) {
    constexpr int rounds = 3;
    constexpr int halvings = 10;
    contacts.set_scales(scales_at(problem, arrangement.growth));
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < problem.size(); ++i) {
            if (problem.pinned[i]) continue;
            const Vec2 here = arrangement.places[i];
            const Vec2 home = moved_into(homes[i], problem.place_range(i, arrangement.growth));
            double share = 1;  // share of the way home; halved until the place is clear
            for (int k = 0; k < halvings; ++k, share /= 2)
                if (is_allowed_place(problem, contacts, arrangement, i, here + (home - here) * share)) {
                    arrangement.places[i] = here + (home - here) * share;
                    break;
                }
        }
}

}  // namespace vitrine::player
