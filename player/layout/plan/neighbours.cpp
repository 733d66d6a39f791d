#include "player/layout/plan/neighbours.hpp"

#include "base/state/media_origin.hpp"
#include "player/layout/cells/sharing.hpp"
#include "player/layout/pack/search_budget.hpp"
#include "player/layout/plan/flat_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>

namespace vitrine::player {

namespace {

constexpr int grid_columns = 64;          // places of the canvas at which the nearest region is looked for
constexpr double max_loss = 0.03;         // share of what I-Regions cover
constexpr double usual_difference = 0.4;  // of unlike pictures
constexpr double moment_share = 0.5;      // of the difference of shots of one moment
constexpr double small_step = 0.8;        // least quotient of a shot's new scale and its own

std::vector<Polygon> regions_of(const PlanRequest& request, const Layout& layout) {
    std::vector<Polygon> regions;
    for (std::size_t i = 0; i < request.items.size(); ++i)
        regions.push_back(placed_region(request.items[i].item, layout.placements[i]));
    return regions;
}

std::size_t nearest(std::span<const Polygon> regions, Vec2 point) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < regions.size() && least > 0; ++i) {
        const double distance = distance_to(regions[i], point);
        if (distance >= least) continue;
        least = distance;
        best = i;
    }
    return best;
}

/// The misfit of an item in another's seat: the difference of their frames' shapes and of their areas.
double misfit(const Polygon& item, const Polygon& seat) {
    const Box a = bounding_box(item);
    const Box b = bounding_box(seat);
    const double shape = std::log(a.width() / a.height()) - std::log(b.width() / b.height());
    const double area = std::log(std::abs(signed_area(item))) - std::log(std::abs(signed_area(seat)));
    return std::abs(shape) + std::abs(area) / 2;
}

/// The search for who stands where.
class SeatSearch {
  public:
    SeatSearch(const PlanRequest& request, const Layout& layout)
        : request_(request),
          regions_(regions_of(request, layout)),
          pairs_(neighbours_of(regions_, layout.canvas)) {
        const std::size_t count = regions_.size();
        differences_.assign(count, std::vector<double>(count));
        misfits_ = differences_;
        for (std::size_t a = 0; a < count; ++a)
            for (std::size_t b = 0; b < count; ++b) {
                differences_[a][b] = unlikeness(request.items[a], request.items[b]);
                misfits_[a][b] = misfit(regions_[a], regions_[b]);
            }
        beside_.resize(count);
        for (const auto& [a, b] : pairs_) {
            beside_[a].push_back(b);
            beside_[b].push_back(a);
        }
    }

    /// Exchanges items as long as that helps, with a chance that sinks for what does not.
    /// @param weight  of a misfit, beside the differences of neighbours
    /// @return seat -> item
    std::vector<std::size_t> best_seats(double weight) const {
        std::vector<std::size_t> seats(regions_.size());
        std::iota(seats.begin(), seats.end(), std::size_t{0});
        Random random(request_.seed);
        const int steps = static_cast<int>(std::min<std::size_t>(60'000, 2'000 * seats.size()));
        constexpr double first_heat = 0.2;
        for (int step = 0; step < steps; ++step) {
            const std::size_t a = uniform_index(random, seats.size());
            const std::size_t b = uniform_index(random, seats.size());
            const double heat = first_heat * std::pow(0.01, step / static_cast<double>(steps));
            const double before = cost(seats, a, b, weight);
            std::swap(seats[a], seats[b]);
            const double rise = cost(seats, a, b, weight) - before;
            if (rise > 0 && uniform(random) >= std::exp(-rise / heat)) std::swap(seats[a], seats[b]);
        }
        return seats;
    }

    const std::vector<Polygon>& regions() const { return regions_; }

  private:
    /// The share of the cost that two seats have, with their neighbours.
    double cost(const std::vector<std::size_t>& seats, std::size_t a, std::size_t b, double weight) const {
        double sum = weight * (misfits_[seats[a]][a] + misfits_[seats[b]][b]);
        for (const std::size_t seat : {a, b})
            for (const std::size_t other : beside_[seat])
                sum += differences_[seats[seat]][seats[other]];
        return sum;
    }

    const PlanRequest& request_;  // outlives this
    std::vector<Polygon> regions_;
    Neighbours pairs_;
    std::vector<std::vector<double>> differences_;
    std::vector<std::vector<double>> misfits_;
    std::vector<std::vector<std::size_t>> beside_;
};

/// The request with all items in the middles of their new seats, about as large as those.
PlanRequest seated(const PlanRequest& request, const Layout& layout, const std::vector<Polygon>& regions,
                   const std::vector<std::size_t>& seats) {
    PlanRequest next = request;
    for (std::size_t seat = 0; seat < seats.size(); ++seat) {
        const std::size_t item = seats[seat];
        const double own = layout.placements[item].scale;
        const double wanted =
            own * std::sqrt(std::abs(signed_area(regions[seat]) / signed_area(regions[item])));
        const double scale = std::clamp(wanted, own * small_step, own / small_step);
        next.items[item].previous =
            Placement{scale, centroid(regions[seat]) - centroid(request.items[item].item.region) * scale};
    }
    return next;
}

}  // namespace

Neighbours neighbours_of(std::span<const Polygon> regions, Vec2 canvas) {
    const double step = canvas.x / grid_columns;
    const int rows = std::max(2, static_cast<int>(std::lround(canvas.y / step)));
    std::vector<std::size_t> owners;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < grid_columns; ++x)
            owners.push_back(nearest(regions, {(x + 0.5) * step, (y + 0.5) * canvas.y / rows}));
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    const auto add = [&](std::size_t a, std::size_t b) {
        if (a != b) pairs.insert(std::minmax(a, b));
    };
    for (std::size_t i = 0; i < owners.size(); ++i) {
        if ((i + 1) % grid_columns != 0) add(owners[i], owners[i + 1]);
        if (i + grid_columns < owners.size()) add(owners[i], owners[i + grid_columns]);
    }
    return {pairs.begin(), pairs.end()};
}

double unlikeness(const PlanItem& a, const PlanItem& b) {
    constexpr double usual_colours = 0.5;  // mean difference of unlike pictures, as a share of the range
    constexpr double max_value = 255;
    double colours = usual_difference;
    if (a.look && b.look) {
        double squares = 0;
        for (std::size_t i = 0; i < a.look->colours.size(); ++i)
            squares += std::pow((a.look->colours[i] - b.look->colours[i]) / max_value, 2);
        colours =
            std::min(1.0, std::sqrt(squares / static_cast<double>(a.look->colours.size())) / usual_colours);
    }
    const bool is_one_moment =
        a.taken && b.taken && std::chrono::abs(*a.taken - *b.taken) <= max_moment_pause;
    return is_one_moment ? colours * moment_share : colours;
}

double mean_unlikeness(const PlanRequest& request, const Layout& layout) {
    const Neighbours pairs = neighbours_of(regions_of(request, layout), layout.canvas);
    double sum = 0;
    for (const auto& [a, b] : pairs)
        sum += unlikeness(request.items[a], request.items[b]);
    return pairs.empty() ? 0 : sum / static_cast<double>(pairs.size());
}

Layout with_alike_neighbours(const PlanRequest& request, const Layout& fresh, const PlanWatch& watch) {
    constexpr int rounds = 2;
    const double least = (1 - fresh.energy) * (1 - max_loss);
    Layout best = fresh;
    double unlike = mean_unlikeness(request, fresh);
    for (int round = 0; round < rounds; ++round) {
        const Layout base = best;
        const SeatSearch search(request, base);
        for (const double weight : {0.02, 0.06, 0.2, 0.6}) {
            const PlanRequest moved = seated(request, base, search.regions(), search.best_seats(weight));
            const auto changed = plan_change(moved, {.should_stop = watch.should_stop});
            if (!changed || 1 - changed->energy < least) continue;
            const double now = mean_unlikeness(request, *changed);
            if (now >= unlike) continue;
            unlike = now;
            best = *changed;
        }
    }
    return best;
}

}  // namespace vitrine::player
