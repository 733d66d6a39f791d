#include "player/layout/pack/compaction.hpp"

#include "player/layout/pack/linear_program.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double trusted_share = 0.05;  // of the field's diagonal: pairs farther apart are left out
constexpr int most_rounds = 12;
constexpr double least_win = 1e-4;      // of the growth, a round; less ends the rounds
constexpr double shrinkage = 1e-6;      // of the growth: what rounding may have taken
constexpr double jitter = 1e-7;         // canvas px, so that no two constraints tie
constexpr double numbers_a_move = 500;  // of the table, changed in the time of an evaluated move

/// One round: the program of the sides that hold the pairs apart now.
class Program {
  public:
    Program(const Ground& ground, const Arrangement& from, const Contacts& contacts)
        : ground_(ground),
          from_(from),
          lp_(2 * ground.size() + 1),
          trust_(trusted_share * length(ground.field.max - ground.field.min)) {
        for (std::size_t i = 0; i < ground.size(); ++i)
            add_walls(i);
        for (std::size_t i = 0; i < ground.size(); ++i)
            for (std::size_t j = i + 1; j < ground.size(); ++j)
                add_pair(i, j, contacts);
        if (ground.reads) add_order();
        add_limit();
    }

    Arrangement solved(Effort& effort) {
        const std::size_t n = ground_.size();
        const std::vector<double> by = lp_.maximise(2 * n, static_cast<int>(20 * n + 100));
        effort.spend(static_cast<std::int64_t>(lp_.pivots() * static_cast<double>(lp_.rows() * (2 * n + 1)) /
                                               numbers_a_move));
        Arrangement to = from_;
        to.growth += by[2 * n];
        for (std::size_t i = 0; i < n; ++i)
            to.places[i] = to.places[i] + Vec2{by[2 * i], by[2 * i + 1]};
        to.growth *= 1 - shrinkage;
        return to;
    }

  private:
    /// The scale's change per growth: none where the item is at its limit or pinned.
    double rate(std::size_t item) const {
        const Growing scale = ground_.growing(item);
        return from_.growth < scale.end() * (1 - 1e-9) ? scale.rate : 0;
    }

    double room(double slack) {
        noise_ = noise_ * 1664525U + 1013904223U;
        return std::max(0.0, slack) + jitter * (1 + noise_ * 0x1p-32);
    }

    void add_walls(std::size_t i) {
        if (ground_.pinned[i]) {
            for (const std::size_t k : {2 * i, 2 * i + 1})
                for (const double turn : {1.0, -1.0})
                    lp_.add_row(0)[k] = turn;
            return;
        }
        const Box range = ground_.range(i, from_.growth);
        const Box& extent = ground_.shapes[i].extent;
        const Vec2 place = from_.places[i];
        const auto add = [&](double slack, std::size_t k, double turn, double reach) {
            const std::span<double> row = lp_.add_row(room(slack));
            row[k] = turn;
            row[2 * ground_.size()] = -reach * rate(i);
        };
        add(place.x - range.min.x, 2 * i, 1, -extent.min.x);
        add(range.max.x - place.x, 2 * i, -1, extent.max.x);
        add(place.y - range.min.y, 2 * i + 1, 1, -extent.min.y);
        add(range.max.y - place.y, 2 * i + 1, -1, extent.max.y);
    }

    void add_pair(std::size_t i, std::size_t j, const Contacts& contacts) {
        if (ground_.pinned[i] && ground_.pinned[j]) return;
        const Vec2 apart = from_.places[j] - from_.places[i];
        const Hold hold = contacts.hold(i, j, apart);
        if (hold.slack > trust_) return;
        const std::span<double> row = lp_.add_row(room(hold.slack));
        row[2 * i] = -hold.normal.x;
        row[2 * i + 1] = -hold.normal.y;
        row[2 * j] = hold.normal.x;
        row[2 * j + 1] = hold.normal.y;
        row[2 * ground_.size()] = -(rate(i) * hold.first + rate(j) * hold.second);
    }

    /// Pairs keep the line, or the lines, on which they stand.
    void add_order() {
        const std::size_t n = ground_.size();
        const ReadingOrder order = reading_order(ground_, from_.growth);
        double rise = 0;  // of half a line, per growth
        for (std::size_t i = 0; i < n; ++i)
            rise += rate(i) * ground_.shapes[i].extent.height() / (2 * static_cast<double>(n));
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + 1; j < n; ++j) {
                if (ground_.pinned[i] && ground_.pinned[j]) continue;
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
        row[2 * ground_.size()] = growing;
    }

    /// Up to where the next item reaches its limit.
    void add_limit() {
        double next = final_growth(ground_);
        for (std::size_t i = 0; i < ground_.size(); ++i)
            if (rate(i) > 0) next = std::min(next, ground_.growing(i).end());
        lp_.add_row(std::max(0.0, next - from_.growth))[2 * ground_.size()] = -1;
    }

    const Ground& ground_;     // outlives this
    const Arrangement& from_;  // outlives this
    LinearProgram lp_;
    double trust_;
    std::uint32_t noise_ = 1;
};

}  // namespace

Arrangement compacted(const Ground& ground, const Arrangement& start, Contacts& contacts, Effort& effort) {
    Arrangement best = start;
    for (int round = 0; round < most_rounds && !effort.is_spent(); ++round) {
        contacts.set_scales(scales_at(ground, best.growth));
        Arrangement next = Program(ground, best, contacts).solved(effort);
        next.growth = greatest_growth(ground, next, contacts, best.growth, next.growth * (1 + 1e-3));
        if (next.growth == 0) break;
        const bool is_worth_more = next.growth > best.growth * (1 + least_win);
        best = std::move(next);
        if (!is_worth_more) break;
    }
    return best;
}

}  // namespace vitrine::player
