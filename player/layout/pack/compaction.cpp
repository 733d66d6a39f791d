#include "player/layout/pack/compaction.hpp"

#include "player/layout/pack/linear_program.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double trusted_share = 0.05;  // share of the field's diagonal; pairs farther apart are left out
constexpr int max_rounds = 12;
constexpr double min_gain = 1e-4;       // share of the growth, gained in a round; less ends the search
constexpr double shrinkage = 1e-6;      // share of the growth, for rounding errors
constexpr double jitter = 1e-7;         // canvas px, so that no two constraints are equal
constexpr double numbers_a_move = 500;  // numbers of the table changed in the time of one evaluated move

/// One round: the linear program with the sides that separate the pairs at present.
class CompactionProgram {
  public:
    CompactionProgram(const PackingProblem& problem, const Arrangement& from, const Contacts& contacts)
        : problem_(problem),
          from_(from),
          lp_(2 * problem.size() + 1),
          trust_(trusted_share * length(problem.field.max - problem.field.min)) {
        for (std::size_t i = 0; i < problem.size(); ++i)
            add_walls(i);
        for (std::size_t i = 0; i < problem.size(); ++i)
            for (std::size_t j = i + 1; j < problem.size(); ++j)
                add_pair(i, j, contacts);
        if (problem.keeps_order) add_order();
        add_limit();
    }

    Arrangement solved(SearchBudget& budget) {
        const std::size_t n = problem_.size();
        const std::vector<double> by = lp_.maximise(2 * n, static_cast<int>(20 * n + 100));
        budget.spend(static_cast<std::int64_t>(lp_.pivots() * static_cast<double>(lp_.rows() * (2 * n + 1)) /
                                               numbers_a_move));
        Arrangement to = from_;
        to.growth += by[2 * n];
        for (std::size_t i = 0; i < n; ++i)
            to.places[i] = to.places[i] + Vec2{by[2 * i], by[2 * i + 1]};
        to.growth *= 1 - shrinkage;
        return to;
    }

  private:
    /// The scale's change per growth; 0 if the item is at its limit or pinned.
    double rate(std::size_t item) const {
        const GrowingScale scale = problem_.growing_scale(item);
        return from_.growth < scale.end() * (1 - 1e-9) ? scale.rate : 0;
    }

    double room(double slack) {
        noise_ = noise_ * 1664525U + 1013904223U;
        return std::max(0.0, slack) + jitter * (1 + noise_ * 0x1p-32);
    }

    void add_walls(std::size_t i) {
        if (problem_.pinned[i]) {
            for (const std::size_t k : {2 * i, 2 * i + 1})
                for (const double turn : {1.0, -1.0})
                    lp_.add_row(0)[k] = turn;
            return;
        }
        const Box range = problem_.place_range(i, from_.growth);
        const Box& extent = problem_.shapes[i].extent;
        const Vec2 place = from_.places[i];
        const auto add = [&](double slack, std::size_t k, double turn, double reach) {
            const std::span<double> row = lp_.add_row(room(slack));
            row[k] = turn;
            row[2 * problem_.size()] = -reach * rate(i);
        };
        add(place.x - range.min.x, 2 * i, 1, -extent.min.x);
        add(range.max.x - place.x, 2 * i, -1, extent.max.x);
        add(place.y - range.min.y, 2 * i + 1, 1, -extent.min.y);
        add(range.max.y - place.y, 2 * i + 1, -1, extent.max.y);
    }

    void add_pair(std::size_t i, std::size_t j, const Contacts& contacts) {
        if (problem_.pinned[i] && problem_.pinned[j]) return;
        const Vec2 apart = from_.places[j] - from_.places[i];
        const SeparatingSide side = contacts.separating_side(i, j, apart);
        if (side.slack > trust_) return;
        const std::span<double> row = lp_.add_row(room(side.slack));
        row[2 * i] = -side.normal.x;
        row[2 * i + 1] = -side.normal.y;
        row[2 * j] = side.normal.x;
        row[2 * j + 1] = side.normal.y;
        row[2 * problem_.size()] = -(rate(i) * side.first + rate(j) * side.second);
    }

    /// Keeps the pairs on their lines.
    void add_order() {
        const std::size_t n = problem_.items();
        const ReadingOrder order = reading_order(problem_, from_.growth);
        double rise = 0;  // change of half a line's height per growth
        for (std::size_t i = 0; i < n; ++i)
            rise += rate(i) * problem_.shapes[i].extent.height() / (2 * static_cast<double>(n));
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + 1; j < n; ++j) {
                if (problem_.pinned[i] && problem_.pinned[j]) continue;
                const Vec2 by = from_.places[j] - from_.places[i];
                const double lower = by.y - order.half_line - ReadingOrder::margin;
                const double higher = by.y + order.half_line - ReadingOrder::margin;
                const double right = by.x - ReadingOrder::margin;
                if (lower >= std::min(higher, right)) {
                    add_difference(lower, 2 * i + 1, 2 * j + 1, -rise);
                    continue;
                }
                add_difference(higher, 2 * i + 1, 2 * j + 1, rise);
                add_difference(right, 2 * i, 2 * j, 0);
            }
    }

    void add_difference(double slack, std::size_t from, std::size_t to, double growing) {
        if (slack > trust_) return;
        const std::span<double> row = lp_.add_row(room(slack));
        row[from] = -1;
        row[to] = 1;
        row[2 * problem_.size()] = growing;
    }

    /// Limits the growth to the next item's limit.
    void add_limit() {
        double next = final_growth(problem_);
        for (std::size_t i = 0; i < problem_.size(); ++i)
            if (rate(i) > 0) next = std::min(next, problem_.growing_scale(i).end());
        lp_.add_row(std::max(0.0, next - from_.growth))[2 * problem_.size()] = -1;
    }

    const PackingProblem& problem_;  // outlives this
    const Arrangement& from_;        // outlives this
    LinearProgram lp_;
    double trust_;  // canvas px of slack; pairs with more are left out
    std::uint32_t noise_ = 1;
};

}  // namespace

Arrangement compacted(const PackingProblem& problem, const Arrangement& start, Contacts& contacts,
                      SearchBudget& budget) {
    Arrangement best = start;
    for (int round = 0; round < max_rounds && !budget.is_spent(); ++round) {
        contacts.set_scales(scales_at(problem, best.growth));
        Arrangement next = CompactionProgram(problem, best, contacts).solved(budget);
        next.growth = max_free_growth(problem, next, contacts, best.growth, next.growth * (1 + 1e-3));
        if (next.growth == 0) break;
        const bool is_worth_more = next.growth > best.growth * (1 + min_gain);
        best = std::move(next);
        if (!is_worth_more) break;
    }
    return best;
}

}  // namespace vitrine::player
