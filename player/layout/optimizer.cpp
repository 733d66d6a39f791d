#include "player/layout/optimizer.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {

namespace {

constexpr double exploring_share = 0.7;   // of the effort, at most
constexpr double exploring_step = 0.006;  // of the growth; area grows twice as much
constexpr double first_step = 0.004;      // of the compression, falling to
constexpr double last_step = 0.0002;
constexpr int exploring_patience = 12;  // rounds without less overlap
constexpr int compressing_patience = 8;
constexpr int vain_trials_a_step = 3;  // compressing: then the step is halved

/// Keeps the best arrangement and grows each found one where it stands.
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

    double step_up(double step) const { return std::min(limit_, arrangement_.growth * (1 + step)); }

    /// @pre found is free
    void take(const Arrangement& found) {
        constexpr double reach = 1.05;
        const double most = std::min(limit_, found.growth * reach);
        const double growth = greatest_growth(ground_, found, contacts_, found.growth, most);
        if (growth < arrangement_.growth) return;
        arrangement_ = {found.places, growth};
        if (on_better_) on_better_(arrangement_);
    }

  private:
    const Ground& ground_;  // outlives this
    Contacts& contacts_;    // outlives this
    const OnBetter& on_better_;
    double limit_;
    Arrangement arrangement_;
};

/// Lets two items change places: what separation by itself hardly ever does.
void disturb(const Ground& ground, Arrangement& arrangement, Random& random) {
    std::vector<std::size_t> movable;
    for (std::size_t i = 0; i < ground.size(); ++i)
        if (!ground.pinned[i]) movable.push_back(i);
    if (movable.size() < 2) return;
    const std::size_t a = uniform_index(random, movable.size());
    const std::size_t b = (a + 1 + uniform_index(random, movable.size() - 1)) % movable.size();
    std::swap(arrangement.places[movable[a]], arrangement.places[movable[b]]);
}

void explore(const Ground& ground, Separation& separation, Best& best, Random& random, Effort& effort,
             std::int64_t until) {
    const SeparationStyle style;
    const std::size_t most_failures = 2 + ground.size() * (ground.size() - 1);  // each pair changed twice
    Arrangement trial = best.arrangement();
    std::size_t failures = 0;  // in a row
    while (failures < most_failures && effort.left() > until && !effort.is_spent() && !best.is_final()) {
        trial.growth = best.step_up(exploring_step);
        if (separation.run(trial, style, effort, exploring_patience)) {
            best.take(trial);
            trial = best.arrangement();
            failures = 0;
            continue;
        }
        if (++failures % 3 == 0) trial = best.arrangement();
        disturb(ground, trial, random);
    }
}

void compress(Separation& separation, Best& best, Effort& effort) {
    const SeparationStyle style;
    int failures = 0;  // at this step
    for (double step = first_step; step >= last_step && !effort.is_spent() && !best.is_final();) {
        Arrangement trial = best.arrangement();
        trial.growth = best.step_up(step);
        if (separation.run(trial, style, effort, compressing_patience)) {
            best.take(trial);
            failures = 0;
        } else if (++failures == vain_trials_a_step) {
            step /= 2;
            failures = 0;
        }
    }
}

}  // namespace

Arrangement densest(const Ground& ground, const Arrangement& start, Random& random, Effort& effort,
                    const OnBetter& on_better) {
    if (ground.size() == 0 || final_growth(ground) == 0) return start;
    Contacts contacts(ground.shapes, ground.clearance);
    Best best(ground, contacts, start, on_better);
    Separation separation(ground, contacts, random);
    const auto until = static_cast<std::int64_t>(static_cast<double>(effort.left()) * (1 - exploring_share));
    explore(ground, separation, best, random, effort, until);
    compress(separation, best, effort);
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
    double step = first_step * 2;
    int failures = 0;
    while (!effort.is_spent() && !best.is_final() && failures < failures_allowed) {
        Arrangement trial = best.arrangement();
        trial.growth = best.step_up(step);
        if (separation.run(trial, style, effort, compressing_patience)) {
            best.take(trial);
            continue;
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
    const auto is_clear = [&](std::size_t i, Vec2 place) {
        for (std::size_t j = 0; j < ground.size(); ++j)
            if (j != i && contacts.depth(i, j, arrangement.places[j] - place) > 0) return false;
        return true;
    };
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < ground.size(); ++i) {
            if (ground.pinned[i]) continue;
            const Vec2 here = arrangement.places[i];
            const Vec2 home = held(homes[i], ground.range(i, arrangement.growth));
            double share = 1;  // of the way home; halved until the place is clear
            for (int k = 0; k < halvings; ++k, share /= 2)
                if (is_clear(i, here + (home - here) * share)) {
                    arrangement.places[i] = here + (home - here) * share;
                    break;
                }
        }
}

}  // namespace vitrine
