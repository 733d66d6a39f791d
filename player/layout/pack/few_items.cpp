#include "player/layout/pack/few_items.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

constexpr std::size_t divisions = 16;  // that are tried
constexpr double emptiness = 10;       // costs of an area without pixels; see FillingTargets
constexpr double heating = 3;          // see FillingTargets
constexpr double trade_share = 0.4;    // see FillingTargets
constexpr std::size_t finalists = 3;   // the best of all, which are annealed once more
constexpr double first_share = 0.7;    // of the budget, for all; the rest is for the finalists
constexpr double min_size = -0.33;     // ln(scale) relative to the fair one: half of its area
constexpr double tiny_cost = 20;       // factor of the square of ln(scale) missing to that
constexpr double max_price_of_way = 0.03 * emptiness;  // of the canvas without pixels

/// The cost of an arrangement, the same for all of one set of items. @pre a growth of 1
double cost_of(const PackingProblem& problem, const FillingTargets& targets, const Arrangement& made) {
    double covered = 0;
    double wished = 0;
    for (std::size_t i = 0; i < problem.size(); ++i) {
        covered += problem.shapes[i].area * problem.scales[i] * problem.scales[i];
        wished += problem.shapes[i].area * targets.natural[i] * targets.natural[i];
    }
    const double growth = std::sqrt(covered / wished);
    double tiny = 0;
    for (std::size_t i = 0; i < problem.size(); ++i) {
        const double fair = std::min(targets.natural[i] * growth, problem.limits[i]);
        const double lack = std::max(0.0, min_size - std::log(problem.scales[i] / fair));
        tiny += tiny_cost * lack * lack;
    }
    return targets.emptiness * exact_unfilled_share(problem, targets.frames, made) -
           covered / problem.field.area() + tiny + way_weight * mean_way(problem, targets, made.places);
}

/// The tries of each annealing where some starts share a number of moves.
int tries_of_each(double moves, std::size_t starts) {
    return static_cast<int>(moves / static_cast<double>(max_annealings * starts));
}

/// An arrangement that is tried, and its cost.
struct Candidate {
    PackingProblem problem;  // with its scales
    Arrangement made;
    double cost = 0;
};

/// The first candidate that the items can reach, or none: the end.
std::vector<Candidate>::iterator first_reachable(std::vector<Candidate>& candidates,
                                                 const FillingTargets& targets) {
    if (!targets.is_reachable) return candidates.begin();
    return std::ranges::find_if(candidates,
                                [&](const Candidate& c) { return targets.is_reachable(c.problem, c.made); });
}

/// Leaves the best candidates, the best one first, and among them one that the items can reach, if there is
/// one.
void keep_finalists(std::vector<Candidate>& candidates, const FillingTargets& targets) {
    std::ranges::sort(candidates, {}, &Candidate::cost);
    if (candidates.size() <= finalists) return;
    const auto last = candidates.begin() + finalists - 1;
    const auto reachable = first_reachable(candidates, targets);
    if (reachable > last && reachable != candidates.end()) std::iter_swap(last, reachable);
    candidates.resize(finalists);
}

/// The best candidate, or one that is hardly worse and that the items can reach. @param candidates  not empty
Candidate& chosen(std::vector<Candidate>& candidates, const FillingTargets& targets) {
    std::ranges::sort(candidates, {}, &Candidate::cost);
    Candidate& best = candidates.front();
    const auto reachable = first_reachable(candidates, targets);
    if (reachable == candidates.end() || reachable->cost > best.cost + max_price_of_way) return best;
    return *reachable;
}

}  // namespace

bool is_for_few(const PackingProblem& problem) {
    const bool has_pinned = std::ranges::find(problem.pinned, true) != problem.pinned.end();
    return problem.size() >= 2 && problem.size() <= max_in_rectangles && !problem.keeps_order && !has_pinned;
}

FillingTargets targets_for_few(FillingTargets targets) {
    targets.emptiness = emptiness;
    targets.fair_size = min_size;
    targets.heating = heating;
    targets.trade_share = trade_share;
    return targets;
}

Arrangement few_filled(PackingProblem& problem, const FillingTargets& targets, const Arrangement& start,
                       Random& random, SearchBudget& budget) {
    FillingTargets wished = targets_for_few(targets);
    std::vector<SizedArrangement> starts = best_rectangles(problem, wished, divisions);
    starts.push_back({start.places, scales_at(problem, start.growth)});
    const auto moves = static_cast<double>(budget.left());
    wished.tries = tries_of_each(first_share * moves, starts.size());
    Contacts contacts(problem.shapes, problem.clearance);
    std::vector<Candidate> candidates;
    for (SizedArrangement& sized : starts) {
        PackingProblem trial = problem;
        trial.scales = std::move(sized.scales);
        Arrangement made{std::move(sized.places), 1};
        if (!is_free(trial, made, contacts)) continue;  // rounding
        made = fill_gaps(trial, wished, made, random, budget);
        const double cost = cost_of(trial, wished, made);
        candidates.push_back({std::move(trial), std::move(made), cost});
    }
    if (candidates.empty()) return start;
    keep_finalists(candidates, targets);
    wished.tries = tries_of_each((1 - first_share) * moves, candidates.size());
    for (Candidate& candidate : candidates) {
        candidate.made = fill_gaps(candidate.problem, wished, candidate.made, random, budget);
        candidate.cost = cost_of(candidate.problem, wished, candidate.made);
    }
    Candidate& best = chosen(candidates, targets);
    problem = std::move(best.problem);
    return std::move(best.made);
}

}  // namespace vitrine::player
