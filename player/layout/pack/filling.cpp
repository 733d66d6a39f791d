#include "player/layout/pack/filling.hpp"

#include "player/layout/pack/compaction.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int columns = 64;  // samples across the canvas; a row is one word
constexpr int rows = 36;
constexpr double edge_share =
    0.0002;  // distance of the outermost samples from the canvas' edge, share of its side: less than a pixel
constexpr double unevenness_weight = 0.05;  // factor of the variance of ln(scale)
constexpr double tininess_weight = 20;      // factor of the mean square of ln(scale) missing to that
constexpr double min_move_share = 0.003;    // shortest random move, share of the field's diagonal
constexpr double max_move_share = 0.3;
constexpr double pull_weight =
    0.15;  // factor of the mean distance from home in diagonals; costs are shares of the canvas
constexpr double max_resize_step = 0.12;  // ln(scale) of a random step
constexpr double at_limit = 0.999;     // share of its largest scale from which an item counts as fully grown
constexpr double max_resizing = 0.35;  // ln(scale) relative to the base
constexpr double min_resizing = -0.5;
constexpr double first_temperature = 0.01;
constexpr double rounding_gain = 1e-9;  // a smaller one is rounding, and no reason to leave a place

/// The range of samples m that have `from` <= m < `to`. There are `samples` samples on [origin, origin +
/// size), at equal distances; the outermost lie near its ends, where a thin band would be seen.
std::array<int, 2> sample_range(double from, double to, double origin, double size, int samples) {
    const double first = origin + edge_share * size;
    const double distance = (1 - 2 * edge_share) * size / (samples - 1);
    const auto index = [&](double x) {
        return static_cast<int>(std::clamp(std::ceil((x - first) / distance), 0.0, 1.0 * samples));
    };
    return {index(from), index(to)};
}

std::uint64_t bits_below(int count) {
    return count >= columns ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

/// The samples of a canvas that lie in frames.
class FramedSamples {
  public:
    explicit FramedSamples(const Box& field) : field_(field) {}

    void add(const Box& frame) {
        const auto [left, right] =
            sample_range(frame.min.x, frame.max.x, field_.min.x, field_.width(), columns);
        const auto [top, bottom] =
            sample_range(frame.min.y, frame.max.y, field_.min.y, field_.height(), rows);
        if (left >= right) return;
        const std::uint64_t bits = bits_below(right) & ~bits_below(left);
        for (int y = top; y < bottom; ++y)
            framed_[static_cast<std::size_t>(y)] |= bits;
    }

    double missing_share() const {
        int sum = 0;
        for (const std::uint64_t row : framed_)
            sum += std::popcount(row);
        return 1 - static_cast<double>(sum) / (columns * rows);
    }

  private:
    Box field_;
    std::array<std::uint64_t, rows> framed_{};  // a bit for each sample
};

Vec2 random_move(const PackingProblem& problem, double max_share, Random& random) {
    const double diagonal = length(problem.field.max - problem.field.min);
    const double reach =
        diagonal * min_move_share * std::pow(1 + max_share / min_move_share, uniform(random));
    const double x = (2 * uniform(random) - 1) * reach;
    const double y = (2 * uniform(random) - 1) * reach;
    const std::size_t kind = uniform_index(random, 4);  // 0: along x only, 1: along y only
    return {kind == 1 ? 0 : x, kind == 0 ? 0 : y};
}

/// The area of a box that others cover. The time doubles with each of them that meets all before it.
double covered_area(std::span<const Box> boxes, const Box& within) {
    double sum = 0;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const Box part = intersection(within, boxes[k]);
        if (!part.is_empty()) sum += part.area() - covered_area(boxes.subspan(k + 1), part);
    }
    return sum;
}

/// A state of the annealing.
struct FillingState {
    Arrangement arrangement;
    std::vector<double> scales;
    double cost = 0;
};

/// The cost of sizes that differ, updated when single sizes change. A size is ln(scale / base).
class SizeSpread {
  public:
    /// @param fair  a smaller size costs more
    explicit SizeSpread(double fair) : fair_(fair) {}

    void add(double size) {
        sum_ += size;
        squares_ += size * size;
        lacks_ += square_of_lack(size);
    }

    void replace(double size, double by) {
        sum_ += by - size;
        squares_ += by * by - size * size;
        lacks_ += square_of_lack(by) - square_of_lack(size);
    }

    /// @param count  the number of sizes
    double cost(double count) const {
        const double variance = squares_ / count - (sum_ / count) * (sum_ / count);
        return unevenness_weight * variance + tininess_weight * lacks_ / count;
    }

  private:
    double square_of_lack(double size) const {
        const double lack = std::max(0.0, fair_ - size);
        return lack * lack;
    }

    double fair_;
    double sum_ = 0, squares_ = 0;
    double lacks_ = 0;  // sum of the squares of what is missing to a fair size
};

/// The share of the canvas without a frame.
double empty_share(const PackingProblem& problem, const FillingTargets& targets,
                   const Arrangement& arrangement) {
    if (targets.frames.empty()) return 0;
    return problem.size() <= max_exact ? exact_unfilled_share(problem, targets.frames, arrangement)
                                       : unfilled_share(problem, targets.frames, arrangement);
}

/// The items of one arrangement, which can be moved and resized one by one, and the cost.
class ItemsToFill {
  public:
    /// @param contacts   contacts of the problem, at any scales
    /// @param loosening  factor of the scales that may become smaller, <= 1, so that there is room to move
    ItemsToFill(const PackingProblem& problem, const FillingTargets& targets, const Contacts& contacts,
                const Arrangement& start, double loosening)
        : problem_(problem),
          targets_(targets),
          contacts_(contacts),
          now_{start.places, 1},
          resized_(problem.size(), 0),
          min_resized_(problem.size(), 0),
          spread_(targets.fair_size) {
        problem_.scales = scales_at(problem, start.growth);
        contacts_.set_scales(problem_.scales);
        base_ = problem_.scales;
        set_base();
        for (std::size_t i = 0; i < problem_.size(); ++i) {
            covered_ += area(i) / problem_.field.area();
            moved_ += distance_home(i);
            if (!problem_.pinned[i] && min_resized_[i] < resized_[i])
                set(i, std::max(resized_[i] + std::log(loosening), min_resized_[i]), now_.places[i]);
        }
    }

    const PackingProblem& problem() const { return problem_; }

    const Arrangement& arrangement() const { return now_; }

    /// The size and place of an item.
    struct State {
        std::size_t item = 0;
        double resized = 0;  // ln(scale / base)
        Vec2 place;          // canvas px
    };

    State state_of(std::size_t item) const { return {item, resized_[item], now_.places[item]}; }

    void restore(const State& state) { set(state.item, state.resized, state.place); }

    void move(std::size_t item, Vec2 by) { set(item, resized_[item], now_.places[item] + by); }

    /// Resizes an item within its limits. @param by  ln(scale)  @param anchor  stays; source px from the
    /// centroid
    void resize(std::size_t item, double by, Vec2 anchor) {
        const double max_resized =
            std::max(resized_[item], std::min(max_resizing, std::log(problem_.limits[item] / base_[item])));
        const double before = problem_.scales[item];
        const Vec2 place = now_.places[item];
        set(item, std::clamp(resized_[item] + by, min_resized_[item], max_resized), place);
        set(item, resized_[item], place + anchor * (before - problem_.scales[item]));
    }

    void keep_inside(std::size_t item) {
        set(item, resized_[item], moved_into(now_.places[item], problem_.place_range(item, 1)));
    }

    bool is_allowed(std::size_t item) const {
        if (!is_allowed_place(problem_, contacts_, now_, item, now_.places[item])) return false;
        return !problem_.keeps_order ||
               is_in_order(problem_, now_.places, 1);  // resizing changes the height of a line
    }

    double cost() const {
        const auto count = static_cast<double>(problem_.size());
        const double pull = pull_weight / (length(problem_.field.max - problem_.field.min) * count);
        return targets_.emptiness * empty_share(problem_, targets_, now_) - covered_ + spread_.cost(count) +
               pull * moved_;
    }

  private:
    double area(std::size_t item) const {
        return problem_.shapes[item].area * problem_.scales[item] * problem_.scales[item];
    }

    /// Sets the base of the sizes: the natural sizes times one factor, the mean of the items that can still
    /// grow.
    void set_base() {
        double sum = 0;
        double count = 0;
        for (std::size_t i = 0; i < problem_.size(); ++i) {
            if (problem_.scales[i] >= problem_.limits[i] * at_limit) continue;
            sum += std::log(problem_.scales[i] / targets_.natural[i]);
            ++count;
        }
        if (count == 0) return;
        const double growth = std::exp(sum / count);
        for (std::size_t i = 0; i < problem_.size(); ++i) {
            base_[i] = std::min(targets_.natural[i] * growth, problem_.limits[i]);
            resized_[i] = std::log(problem_.scales[i] / base_[i]);
            const double wished = std::log(targets_.natural[i] * growth / base_[i]);
            min_resized_[i] = std::min(resized_[i], std::min(0.0, wished + min_resizing));
            spread_.add(resized_[i]);
        }
    }

    double distance_home(std::size_t item) const {
        return targets_.homes.empty() ? 0 : length(now_.places[item] - targets_.homes[item]);
    }

    void set(std::size_t item, double resized, Vec2 place) {
        moved_ -= distance_home(item);
        now_.places[item] = place;
        moved_ += distance_home(item);
        const double was = resized_[item];
        if (resized == was) return;
        covered_ -= area(item) / problem_.field.area();
        problem_.scales[item] = base_[item] * std::exp(resized);
        covered_ += area(item) / problem_.field.area();
        contacts_.set_scale(item, problem_.scales[item]);
        spread_.replace(was, resized);
        resized_[item] = resized;
    }

    PackingProblem problem_;
    const FillingTargets& targets_;  // outlives this
    Contacts contacts_;
    Arrangement now_;
    std::vector<double> base_;         // the scales that items would have if only their weights counted
    std::vector<double> resized_;      // ln(scale / base), one for each item
    std::vector<double> min_resized_;  // lower limits of resized_: items below their wish do not shrink
    SizeSpread spread_;                // spread of resized_
    double covered_ = 0;               // area of the I-Regions, share of the field
    double moved_ = 0;                 // sum of all items' distances from home, canvas px
};

/// Simulated annealing of the items of one arrangement.
class GapFilling {
  public:
    /// @param temperature  at the start
    GapFilling(const FillingTargets& targets, ItemsToFill items, double temperature)
        : targets_(targets), items_(std::move(items)), temperature_(temperature), cost_(items_.cost()) {
        keep();
    }

    void run(int tries, Random& random, SearchBudget& budget) {
        const PackingProblem& problem = items_.problem();
        for (int k = 0; k < tries && !budget.is_spent(); ++k) {
            const double left = 1 - static_cast<double>(k) / tries;
            const std::size_t item = uniform_index(random, problem.size());
            if (problem.pinned[item]) continue;
            budget.spend();
            if (targets_.trade_share > 0 && uniform(random) < targets_.trade_share)
                trade_sizes(item, left, random);
            else
                change(item, left, random);
        }
    }

    const FillingState& best() const { return best_; }

  private:
    /// Tries one change of an item. @param wide  from 1 at the start to 0 at the end: steps get smaller with
    /// it, and the temperature falls with its square
    void change(std::size_t item, double wide, Random& random) {
        const ItemsToFill::State before = items_.state_of(item);
        if (uniform_index(random, 2) == 0)
            resize(item, max_resize(wide) * (2 * uniform(random) - 1), random);
        else
            items_.move(item, random_move(items_.problem(), wide * max_move(), random));
        items_.keep_inside(item);
        if (!items_.is_allowed(item) || !is_accepted(wide, random)) items_.restore(before);
    }

    /// Tries to make one item larger and another one smaller. Steps of one item lead there only through
    /// states with a larger gap. @param wide  as for change()
    void trade_sizes(std::size_t larger, double wide, Random& random) {
        const PackingProblem& problem = items_.problem();
        const std::size_t others = problem.size() - 1;
        const std::size_t smaller = (larger + 1 + uniform_index(random, others)) % problem.size();
        if (problem.pinned[smaller]) return;
        const ItemsToFill::State larger_before = items_.state_of(larger);
        const ItemsToFill::State smaller_before = items_.state_of(smaller);
        const double growth = max_resize(wide) * uniform(random);
        const double loss = max_resize(wide) * uniform(random);
        resize(smaller, -loss, random);
        resize(larger, growth, random);
        items_.keep_inside(larger);
        items_.keep_inside(smaller);
        if (items_.is_allowed(larger) && items_.is_allowed(smaller) && is_accepted(wide, random)) return;
        items_.restore(larger_before);
        items_.restore(smaller_before);
    }

    /// True if the state is kept: it costs less, or chance allows it.
    bool is_accepted(double wide, Random& random) {
        const double there = items_.cost();
        const double temperature = temperature_ * wide * wide;
        if (there > cost_ && uniform(random) >= std::exp((cost_ - there) / temperature)) return false;
        cost_ = there;
        if (cost_ < best_.cost - rounding_gain) keep();
        return true;
    }

    /// Resizes an item about a corner, the middle of a side or the middle. @param by  ln(scale)
    void resize(std::size_t item, double by, Random& random) {
        const Box& extent = items_.problem().shapes[item].extent;
        const double x = static_cast<double>(uniform_index(random, 3)) / 2;
        const double y = static_cast<double>(uniform_index(random, 3)) / 2;
        items_.resize(item, by, {extent.min.x + x * extent.width(), extent.min.y + y * extent.height()});
    }

    static double max_resize(double wide) { return max_resize_step * (0.1 + 0.9 * wide); }

    /// The limit of a random move, as a share of the field's diagonal.
    double max_move() const { return targets_.homes.empty() ? max_move_share : targets_.max_way; }

    void keep() { best_ = {items_.arrangement(), items_.problem().scales, cost_}; }

    const FillingTargets& targets_;  // outlives this
    ItemsToFill items_;
    double temperature_;
    double cost_;
    FillingState best_;
};

}  // namespace

double unfilled_share(const PackingProblem& problem, std::span<const Box> frames,
                      const Arrangement& arrangement) {
    FramedSamples samples(problem.whole());
    for (std::size_t i = 0; i < problem.size(); ++i) {
        const double scale = problem.scale(i, arrangement.growth);
        samples.add(
            {arrangement.places[i] + frames[i].min * scale, arrangement.places[i] + frames[i].max * scale});
    }
    return samples.missing_share();
}

double exact_unfilled_share(const PackingProblem& problem, std::span<const Box> frames,
                            const Arrangement& arrangement) {
    std::vector<Box> boxes;
    boxes.reserve(problem.size());
    for (std::size_t i = 0; i < problem.size(); ++i) {
        const double scale = problem.scale(i, arrangement.growth);
        boxes.push_back(
            {arrangement.places[i] + frames[i].min * scale, arrangement.places[i] + frames[i].max * scale});
    }
    return 1 - covered_area(boxes, problem.whole()) / problem.whole().area();
}

double mean_way(const PackingProblem& problem, const FillingTargets& targets, std::span<const Vec2> places) {
    if (targets.homes.empty()) return 0;
    double sum = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        sum += length(places[i] - targets.homes[i]);
    return sum / (length(problem.field.max - problem.field.min) * static_cast<double>(places.size()));
}

Arrangement fill_gaps(PackingProblem& problem, const FillingTargets& targets, const Arrangement& start,
                      Random& random, SearchBudget& budget) {
    if (problem.size() == 0 || problem.size() > max_filled) return start;

    constexpr std::array<double, max_annealings> free = {0.97, 0.95, 0.9};
    constexpr std::array<double, 2> calm = {0.99, 0.97};
    const bool is_free = targets.homes.empty();
    const auto loosenings = is_free ? std::span<const double>(free) : std::span<const double>(calm);
    const int tries = is_free ? targets.tries : targets.tries / 2;
    const Contacts contacts(problem.shapes, problem.clearance);
    FillingState best{start, problem.scales, ItemsToFill(problem, targets, contacts, start, 1).cost()};
    double temperature = first_temperature;
    for (const double loosening : loosenings) {
        GapFilling filling(targets, {problem, targets, contacts, start, loosening}, temperature);
        filling.run(tries, random, budget);
        if (filling.best().cost < best.cost) best = filling.best();
        if (budget.is_spent()) break;
        temperature *= targets.heating;
    }
    problem.scales = best.scales;
    return best.arrangement;
}

}  // namespace vitrine::player
