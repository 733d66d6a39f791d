#include "player/layout/pack/filling.hpp"

#include "player/layout/pack/compaction.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace vitrine::player {

namespace {

constexpr int columns = 64;  // of samples; a row is one word
constexpr int rows = 36;
constexpr double background_weight = 3;
constexpr double unevenness_weight = 0.05;  // of the variance of ln(scale), against shares of the canvas
constexpr double nearest = 0.003;           // of the field's diagonal, of a random move
constexpr double farthest = 0.3;
constexpr double farthest_from_home = 0.05;
constexpr double pull_weight = 0.15;   // of the mean way from home in diagonals, against shares of the canvas
constexpr double most_resized = 0.12;  // ln(scale) of a random step
constexpr double at_limit = 0.999;     // of the scale that an item may have at most: it grows no more
constexpr double most_larger = 0.35;   // ln(scale), than at the start
constexpr double most_smaller = -0.5;
constexpr double first_temperature = 0.01;
constexpr std::size_t most_items = 48;  // of more, pictures fill the canvas by themselves

/// Those of some samples over [origin, origin + size) with `from` <= middle < `to`, as a range.
std::array<int, 2> sample_range(double from, double to, double origin, double size, int samples) {
    const auto index = [&](double x) {
        return static_cast<int>(
            std::clamp(std::ceil((x - origin) / size * samples - 0.5), 0.0, 1.0 * samples));
    };
    return {index(from), index(to)};
}

std::uint64_t bits_below(int count) {
    return count >= columns ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

Vec2 random_way(const Ground& ground, double farthest_share, Random& random) {
    const double most = length(ground.field.max - ground.field.min);
    const double reach = most * nearest * std::pow(1 + farthest_share / nearest, uniform(random));
    const double x = (2 * uniform(random) - 1) * reach;
    const double y = (2 * uniform(random) - 1) * reach;
    const std::size_t kind = uniform_index(random, 4);  // 0: along x only, 1: along y only
    return {kind == 1 ? 0 : x, kind == 0 ? 0 : y};
}

/// An annealing from one arrangement, all of it made smaller at first so that there is room to move.
class Filling {
  public:
    /// @param contacts  of the ground, at any scales
    Filling(const Ground& ground, const FillingWishes& wishes, const Contacts& contacts,
            const Arrangement& start, double loosening, Random& random)
        : ground_(ground),
          wishes_(wishes),
          contacts_(contacts),
          now_{start.places, 1},
          random_(random),
          resized_(ground.size(), 0),
          least_(ground.size(), 0) {
        const double diagonal = length(ground.field.max - ground.field.min);
        pull_ = pull_weight / (diagonal * static_cast<double>(ground.size()));
        farthest_ = wishes.homes.empty() ? farthest : farthest_from_home;
        ground_.scales = scales_at(ground, start.growth);
        contacts_.set_scales(ground_.scales);
        base_ = ground_.scales;
        set_base();
        for (std::size_t i = 0; i < ground_.size(); ++i) {
            covered_ += area(i) / ground_.field.area();
            moved_ += distance_home(i);
            if (!ground_.pinned[i] && least_[i] < resized_[i])
                set(i, std::max(resized_[i] + std::log(loosening), least_[i]), now_.places[i]);
        }
        cost_ = cost();
        keep();
    }

    void run(int tries, Effort& effort) {
        for (int k = 0; k < tries && !effort.is_spent(); ++k) {
            const double left = 1 - static_cast<double>(k) / tries;
            const std::size_t item = uniform_index(random_, ground_.size());
            if (ground_.pinned[item]) continue;
            effort.spend();
            step(item, first_temperature * left * left, left);
        }
    }

    double best_cost() const { return best_cost_; }

    const Arrangement& best() const { return best_; }

    const std::vector<double>& best_scales() const { return best_scales_; }

  private:
    double area(std::size_t item) const {
        return ground_.shapes[item].area * ground_.scales[item] * ground_.scales[item];
    }

    double cost() const {
        const auto count = static_cast<double>(ground_.size());
        const double unevenness = squares_ / count - (sum_ / count) * (sum_ / count);
        const double empty = wishes_.frames.empty() ? 0 : unfilled(ground_, wishes_.frames, now_);
        return background_weight * empty - covered_ + unevenness_weight * unevenness + pull_ * moved_;
    }

    void step(std::size_t item, double temperature, double wide) {
        const Vec2 place = now_.places[item];
        const double resized = resized_[item];
        if (uniform_index(random_, 2) == 0)
            resize(item, wide);
        else
            set(item, resized, place + random_way(ground_, wide * farthest_, random_));
        set(item, resized_[item], held(now_.places[item], ground_.range(item, 1)));
        if (is_allowed(item)) {
            const double there = cost();
            if (there <= cost_ || uniform(random_) < std::exp((cost_ - there) / temperature)) {
                cost_ = there;
                if (cost_ < best_cost_) keep();
                return;
            }
        }
        set(item, resized, place);
    }

    bool is_allowed(std::size_t item) const {
        if (!may_stand(ground_, contacts_, now_, item, now_.places[item])) return false;
        return !ground_.reads || is_in_order(ground_, now_.places, 1);  // sizes say how high a line is
    }

    /// Larger or smaller about a corner, the middle of a side or the middle.
    void resize(std::size_t item, double wide) {
        const double most =
            std::max(resized_[item], std::min(most_larger, std::log(ground_.limits[item] / base_[item])));
        const double by = most_resized * (0.1 + 0.9 * wide) * (2 * uniform(random_) - 1);
        const Box& extent = ground_.shapes[item].extent;
        const double x = static_cast<double>(uniform_index(random_, 3)) / 2;
        const double y = static_cast<double>(uniform_index(random_, 3)) / 2;
        const Vec2 anchor{extent.min.x + x * extent.width(), extent.min.y + y * extent.height()};
        const double before = ground_.scales[item];
        const Vec2 place = now_.places[item];
        set(item, std::clamp(resized_[item] + by, least_[item], most), place);
        set(item, resized_[item], place + anchor * (before - ground_.scales[item]));
    }

    /// What sizes are measured by: the natural ones, all as large as those are now that can still grow.
    void set_base() {
        double sum = 0;
        double count = 0;
        for (std::size_t i = 0; i < ground_.size(); ++i) {
            if (ground_.scales[i] >= ground_.limits[i] * at_limit) continue;
            sum += std::log(ground_.scales[i] / wishes_.natural[i]);
            ++count;
        }
        if (count == 0) return;
        const double growth = std::exp(sum / count);
        for (std::size_t i = 0; i < ground_.size(); ++i) {
            base_[i] = std::min(wishes_.natural[i] * growth, ground_.limits[i]);
            resized_[i] = std::log(ground_.scales[i] / base_[i]);
            const double wished = std::log(wishes_.natural[i] * growth / base_[i]);
            least_[i] = std::min(resized_[i], std::min(0.0, wished + most_smaller));
            sum_ += resized_[i];
            squares_ += resized_[i] * resized_[i];
        }
    }

    double distance_home(std::size_t item) const {
        return wishes_.homes.empty() ? 0 : length(now_.places[item] - wishes_.homes[item]);
    }

    void set(std::size_t item, double resized, Vec2 place) {
        moved_ -= distance_home(item);
        now_.places[item] = place;
        moved_ += distance_home(item);
        const double was = resized_[item];
        if (resized == was) return;
        covered_ -= area(item) / ground_.field.area();
        ground_.scales[item] = base_[item] * std::exp(resized);
        covered_ += area(item) / ground_.field.area();
        contacts_.set_scale(item, ground_.scales[item]);
        sum_ += resized - was;
        squares_ += resized * resized - was * was;
        resized_[item] = resized;
    }

    void keep() {
        best_cost_ = cost_;
        best_ = now_;
        best_scales_ = ground_.scales;
    }

    Ground ground_;
    const FillingWishes& wishes_;  // outlives this
    Contacts contacts_;
    Arrangement now_;
    Random& random_;                // outlives this
    std::vector<double> base_;      // scales that items would have if only their weights counted
    std::vector<double> resized_;   // ln of the scale and that, one an item
    std::vector<double> least_;     // of them: an item that may not be as large as it should shrinks no more
    double sum_ = 0, squares_ = 0;  // of them
    double covered_ = 0;            // share of the field
    double moved_ = 0;              // canvas px from home, of all together
    double pull_ = 0;               // cost of a px of it
    double farthest_ = 0;           // of the field's diagonal, of a random move
    double cost_ = 0;
    Arrangement best_;
    std::vector<double> best_scales_;
    double best_cost_ = 0;
};

}  // namespace

double unfilled(const Ground& ground, std::span<const Box> frames, const Arrangement& arrangement) {
    std::array<std::uint64_t, rows> covered{};
    const Box& field = ground.field;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const double scale = ground.scale(i, arrangement.growth);
        const Vec2 low = arrangement.places[i] + frames[i].min * scale;
        const Vec2 high = arrangement.places[i] + frames[i].max * scale;
        const auto [left, right] = sample_range(low.x, high.x, field.min.x, field.width(), columns);
        const auto [top, bottom] = sample_range(low.y, high.y, field.min.y, field.height(), rows);
        if (left >= right) continue;
        const std::uint64_t bits = bits_below(right) & ~bits_below(left);
        for (int y = top; y < bottom; ++y)
            covered[static_cast<std::size_t>(y)] |= bits;
    }
    int sum = 0;
    for (const std::uint64_t row : covered)
        sum += std::popcount(row);
    return 1 - static_cast<double>(sum) / (columns * rows);
}

Arrangement filled(Ground& ground, const FillingWishes& wishes, const Arrangement& start, Random& random,
                   Effort& effort) {
    if (ground.size() == 0 || ground.size() > most_items) return start;

    struct Annealing {
        double loosening = 1;
        int tries = 0;
    };

    constexpr Annealing free[] = {{0.97, 60'000}, {0.95, 60'000}, {0.9, 60'000}};
    constexpr Annealing calm[] = {{0.99, 30'000}, {0.97, 30'000}};
    const auto annealings =
        wishes.homes.empty() ? std::span<const Annealing>(free) : std::span<const Annealing>(calm);
    const Contacts contacts(ground.shapes, ground.clearance);
    double least = Filling(ground, wishes, contacts, start, 1, random).best_cost();
    Ground found = ground;
    Arrangement best = start;
    for (const Annealing& annealing : annealings) {
        Filling filling(ground, wishes, contacts, start, annealing.loosening, random);
        filling.run(annealing.tries, effort);
        if (filling.best_cost() < least) {
            least = filling.best_cost();
            best = filling.best();
            found.scales = filling.best_scales();
        }
        if (effort.is_spent()) break;
    }
    ground.scales = found.scales;
    return best;
}

}  // namespace vitrine::player
