// PatchMatch (Barnes et al. 2009): good matches are found by chance and spread to the neighbours. Both fields
// are cut into bands of rows that are swept independently, so that several threads can share a sweep and the
// result does not depend on how many there are; the bands' borders move from sweep to sweep.

#include "analyzer/tapestry/synthesis/patch_match.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::analyzer {

namespace {

constexpr int band_rows = 32;  // px
constexpr int unbounded = std::numeric_limits<int>::max();

/// A small generator of random numbers, good enough to choose places to search.
class Chance {
  public:
    explicit Chance(std::uint32_t seed) : state_(seed * 2654435761U + 0x9E3779B9U) {
        for (int i = 0; i < 3; ++i)
            (void)next();
    }

    /// [-reach, reach]
    int within(int reach) {
        return static_cast<int>((std::uint64_t{next()} * std::uint64_t{as_index(2 * reach + 1)}) >> 32U) -
               reach;
    }

  private:
    std::uint32_t next() {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 17U;
        state_ ^= state_ << 5U;
        return state_;
    }

    std::uint32_t state_;
};

/// The first row of each band, and the end.
std::vector<int> band_borders(int rows, std::uint32_t seed) {
    std::vector<int> borders{0};
    for (int row = band_rows - static_cast<int>(seed % 2) * band_rows / 2; row + band_rows / 2 < rows;
         row += band_rows)
        borders.push_back(row);
    borders.push_back(rows);
    return borders;
}

}  // namespace

PatchRules free_rules(const PatchImage& source) {
    PatchRules rules;
    rules.owners.assign(
        static_cast<std::size_t>(source.patch_columns()) * static_cast<std::size_t>(source.patch_rows()), 0);
    rules.weights.assign(rules.owners.size(), 0);
    rules.centres = {0};
    return rules;
}

PatchMatch::PatchMatch(const PatchImage& source, const PatchImage& target, const PatchRules& rules)
    : source_(source),
      target_(target),
      rules_(rules),
      distance_(patch_distance()),
      of_target_(target.patch_columns(), target.patch_rows()),
      of_source_(source.patch_columns(), source.patch_rows()) {
    for (const std::uint8_t weight : rules.weights)
        source_weight_ += weight;
}

int PatchMatch::time_cost(int source_x, int source_y, int target_x) const {
    const int centre = rules_.centres[static_cast<std::size_t>(owner(source_x, source_y))];
    const double beyond = std::abs(centre - rules_.target_x - target_x - patch_side / 2) - rules_.reach;
    return beyond > 0 ? static_cast<int>(std::min(1e8, rules_.time_cost * beyond * beyond)) : 0;
}

int PatchMatch::cost(int source_x, int source_y, int target_x, int target_y, int bound) const {
    const int time = time_cost(source_x, source_y, target_x);
    if (time > bound) return time;
    return time + distance_(source_.at(source_x, source_y), source_.stride(), target_.at(target_x, target_y),
                            target_.stride(), bound - time);
}

/// The nearest allowed place along the row, then along the column.
Match PatchMatch::allowed_near(int x, int y) const {
    x = std::clamp(x, 0, of_source_.columns - 1);
    y = std::clamp(y, 0, of_source_.rows - 1);
    for (int reach = 0; reach < of_source_.columns + of_source_.rows; ++reach) {
        for (const int step : {-reach, reach}) {
            const int column = std::clamp(x + step, 0, of_source_.columns - 1);
            const int row = std::clamp(y + step, 0, of_source_.rows - 1);
            if (is_allowed(column, y))
                return {.x = static_cast<std::int16_t>(column), .y = static_cast<std::int16_t>(y)};
            if (is_allowed(x, row))
                return {.x = static_cast<std::int16_t>(x), .y = static_cast<std::int16_t>(row)};
        }
    }
    for (int row = 0; row < of_source_.rows; ++row)
        for (int column = 0; column < of_source_.columns; ++column)
            if (is_allowed(column, row))
                return {.x = static_cast<std::int16_t>(column), .y = static_cast<std::int16_t>(row)};
    return {.x = 0, .y = 0};
}

void PatchMatch::refresh_row_of_target(int y) {
    for (int x = 0; x < of_target_.columns; ++x) {
        Match& match = of_target_.at(x, y);
        if (match.x < 0 || match.y < 0 || match.x >= of_source_.columns || match.y >= of_source_.rows ||
            !is_allowed(match.x, match.y))
            match = allowed_near(match.x, match.y);
        match.cost = cost(match.x, match.y, x, y, unbounded);
    }
}

void PatchMatch::refresh_row_of_source(int y) {
    for (int x = 0; x < of_source_.columns; ++x) {
        Match& match = of_source_.at(x, y);
        if (rules_.weights[place(x, y)] == 0) {
            match = {};
            continue;
        }
        match.x = static_cast<std::int16_t>(std::clamp<int>(match.x, 0, of_target_.columns - 1));
        match.y = static_cast<std::int16_t>(std::clamp<int>(match.y, 0, of_target_.rows - 1));
        match.cost = cost(x, y, match.x, match.y, unbounded);
    }
}

void PatchMatch::in_bands(std::uint32_t seed, const RunTasks& run, const BandWork& work) const {
    const std::vector<int> target_bands = band_borders(of_target_.rows, seed);
    const std::vector<int> source_bands = band_borders(of_source_.rows, seed);
    const int of_target = static_cast<int>(target_bands.size()) - 1;
    const int all = of_target + static_cast<int>(source_bands.size()) - 1;
    run(all, [&](int task) {
        const bool is_target = task < of_target;
        const std::vector<int>& bands = is_target ? target_bands : source_bands;
        const auto band = static_cast<std::size_t>(is_target ? task : task - of_target);
        work({.task = task, .is_target = is_target, .first = bands[band], .last = bands[band + 1]});
    });
}

void PatchMatch::refresh(const RunTasks& run) {
    in_bands(0, run, [&](const Band& band) {
        for (int y = band.first; y < band.last; ++y) {
            if (band.is_target)
                refresh_row_of_target(y);
            else
                refresh_row_of_source(y);
        }
    });
}

/// Sweeps over one band of one field, from one corner to the opposite one.
struct PatchMatch::Sweep {
    PatchMatch& fields;
    bool is_target;  // the target's field; else the source's
    int first;
    int last;
    bool is_forward;
    int radius;
    int near_enough;
    Chance chance;

    MatchField& field() const { return is_target ? fields.of_target_ : fields.of_source_; }

    bool may_be(int x, int y) const {
        const MatchField& other = is_target ? fields.of_source_ : fields.of_target_;
        if (x < 0 || y < 0 || x >= other.columns || y >= other.rows) return false;
        return !is_target || fields.is_allowed(x, y);
    }

    void offer(Match& best, int x, int y, int to_x, int to_y) const {
        if ((to_x == best.x && to_y == best.y) || !may_be(to_x, to_y)) return;
        const int cost =
            is_target ? fields.cost(to_x, to_y, x, y, best.cost) : fields.cost(x, y, to_x, to_y, best.cost);
        if (cost < best.cost)
            best = {.x = static_cast<std::int16_t>(to_x), .y = static_cast<std::int16_t>(to_y), .cost = cost};
    }

    void visit(int x, int y) {
        Match& best = field().at(x, y);
        if (best.x < 0 || best.cost == 0) return;
        const int step = is_forward ? -1 : 1;
        if (x + step >= 0 && x + step < field().columns) {
            const Match& beside = field().at(x + step, y);
            if (beside.x >= 0) offer(best, x, y, beside.x - step, beside.y);
        }
        if (y + step >= first && y + step < last) {
            const Match& above = field().at(x, y + step);
            if (above.x >= 0) offer(best, x, y, above.x, above.y - step);
        }
        if (best.cost < near_enough) return;
        for (int reach = radius; reach > 0; reach /= 2) {
            Match found = best;
            found.cost -= near_enough / 2;
            offer(found, x, y, best.x + chance.within(reach), best.y + chance.within(reach));
            if (found.x != best.x || found.y != best.y) best = found;
        }
    }

    void run() {
        const int columns = field().columns;
        for (int i = 0; i < last - first; ++i) {
            const int y = is_forward ? first + i : last - 1 - i;
            for (int j = 0; j < columns; ++j)
                visit(is_forward ? j : columns - 1 - j, y);
        }
    }
};

void PatchMatch::search(int radius, std::uint32_t seed, const RunTasks& run, int near_enough) {
    in_bands(seed, run, [&](const Band& band) {
        Sweep{.fields = *this,
              .is_target = band.is_target,
              .first = band.first,
              .last = band.last,
              .is_forward = seed % 2 == 0,
              .radius = radius,
              .near_enough = near_enough,
              .chance = Chance(seed * 1000U + static_cast<std::uint32_t>(band.task))}
            .run();
    });
}

void PatchMatch::share() {
    const auto at = [](int x, int y, int cost) {
        return Match{.x = static_cast<std::int16_t>(x), .y = static_cast<std::int16_t>(y), .cost = cost};
    };
    for (int y = 0; y < of_source_.rows; ++y) {
        for (int x = 0; x < of_source_.columns; ++x) {
            const Match& match = of_source_.at(x, y);
            if (match.x < 0) continue;
            Match& back = of_target_.at(match.x, match.y);
            if (match.cost < back.cost) back = at(x, y, match.cost);
        }
    }
    for (int y = 0; y < of_target_.rows; ++y) {
        for (int x = 0; x < of_target_.columns; ++x) {
            const Match& match = of_target_.at(x, y);
            Match& back = of_source_.at(match.x, match.y);
            if (back.x >= 0 && match.cost < back.cost) back = at(x, y, match.cost);
        }
    }
}

void PatchMatch::search_everywhere() {
    for (int sy = 0; sy < of_source_.rows; ++sy) {
        for (int sx = 0; sx < of_source_.columns; ++sx) {
            if (!is_allowed(sx, sy)) continue;
            for (int ty = 0; ty < of_target_.rows; ++ty) {
                for (int tx = 0; tx < of_target_.columns; ++tx) {
                    Match& of_source = of_source_.at(sx, sy);
                    Match& of_target = of_target_.at(tx, ty);
                    const int value = cost(sx, sy, tx, ty, unbounded);
                    if (of_source.x >= 0 && value < of_source.cost)
                        of_source = {.x = static_cast<std::int16_t>(tx),
                                     .y = static_cast<std::int16_t>(ty),
                                     .cost = value};
                    if (value < of_target.cost)
                        of_target = {.x = static_cast<std::int16_t>(sx),
                                     .y = static_cast<std::int16_t>(sy),
                                     .cost = value};
                }
            }
        }
    }
}

double PatchMatch::energy() const {
    double complete = 0;
    double coherent = 0;
    for (std::size_t i = 0; i < of_source_.matches.size(); ++i)
        complete += rules_.weights[i] * static_cast<double>(of_source_.matches[i].cost);
    for (const Match& match : of_target_.matches)
        coherent += match.cost;
    return (complete / std::max(1.0, source_weight_) +
            coherent / static_cast<double>(of_target_.matches.size())) /
           patch_values;
}

}  // namespace vitrine::analyzer
