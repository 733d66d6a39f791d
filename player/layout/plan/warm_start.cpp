#include "player/layout/plan/warm_start.hpp"

#include "player/layout/pack/compaction.hpp"
#include "player/layout/pack/optimizer.hpp"
#include "player/layout/pack/separation.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double max_apart = 2;  // largest quotient of a scale and the natural one
constexpr double fair_scale =
    0.75;  // share of the natural scale: 0.56 of the area. No item becomes smaller unless all do
constexpr int patience = 4;  // rounds of separation without less overlap
constexpr double newcomer_shrink = 0.93;
constexpr double first_common_shrink = 0.02;  // share of the scale; it rises with each further shrink
constexpr double common_shrink_rise = 1.35;
constexpr double max_common_shrink = 0.2;
constexpr int shrinks_of_newcomers = 6;
constexpr double colliding_shrink = 0.95;
constexpr int shrinks_of_colliding = 12;
constexpr int shrinks_of_all = 16;
constexpr int rounds_back = 3;  // rounds of returning home and to the old size

bool takes_a_seat(const PlanItem& item) {
    return item.seat && item.seat->area > 0;
}

/// True if an item comes in addition to the placed items, so that they must make room.
bool is_inserted(const PlanItem& item) {
    return !item.previous && !takes_a_seat(item);
}

Placement home_of(const PlanItem& item) {
    return item.home.value_or(*item.previous);
}

/// The growth at which natural scales equal those of the kept items: the median of the quotients.
double growth_of_kept(const PlanRequest& request, const PackingProblem& problem) {
    std::vector<double> growths;
    for (std::size_t i = 0; i < problem.items(); ++i)
        if (request.items[i].previous)
            growths.push_back(request.items[i].previous->scale / problem.scales[i]);
    std::sort(growths.begin(), growths.end());
    return growths[growths.size() / 2];
}

/// Sets every scale for a growth of 1. Inserted items come in addition, so all unpinned items make room.
/// @return the least fair scale of each item
std::vector<double> set_scales(const PlanRequest& request, PackingProblem& problem) {
    const double growth = growth_of_kept(request, problem);
    std::vector<double> fair_scales = problem.scales;
    double kept_area = 0;
    double inserted_area = 0;
    for (std::size_t i = 0; i < problem.items(); ++i) {
        const PlanItem& item = request.items[i];
        const double natural = problem.scales[i] * growth;
        double scale = natural;
        if (item.previous)
            scale = problem.pinned[i] ? item.previous->scale : home_of(item).scale;
        else if (takes_a_seat(item))
            scale = std::sqrt(item.seat->area / problem.shapes[i].area);
        const double least = natural * (item.previous ? 1 / max_apart : fair_scale);
        if (!problem.pinned[i]) scale = std::clamp(scale, least, natural * max_apart);
        problem.scales[i] = problem.pinned[i] ? scale : std::min(scale, problem.limits[i]);
        const double area = problem.shapes[i].area * problem.scales[i] * problem.scales[i];
        (is_inserted(item) ? inserted_area : kept_area) += area;
    }
    const double room = std::sqrt(kept_area / (kept_area + inserted_area));
    for (std::size_t i = 0; i < problem.size(); ++i) {
        if (!problem.pinned[i]) problem.scales[i] *= room;
        fair_scales[i] *= growth * room * fair_scale;
    }
    return fair_scales;
}

/// The items that shrink if they cannot be separated.
enum class Shrinking { newcomers, colliding, all };

/// One change of a wall in the making.
class WarmStart {
  public:
    /// All are borrowed and must outlive this.
    WarmStart(const PlanRequest& request, PackingProblem& problem, Random& random, SearchBudget& budget)
        : request_(request),
          problem_(problem),
          random_(random),
          budget_(budget),
          contacts_(problem.shapes, problem.clearance) {}

    std::optional<Arrangement> run() {
        fair_scales_ = set_scales(request_, problem_);
        const std::vector<double> wished_scales = problem_.scales;
        const std::vector<Vec2> starts = start_places();
        const std::vector<Vec2> homes = home_places(starts);
        Arrangement arrangement{starts, 1};
        if (!separate(arrangement, homes)) {
            arrangement.places = starts;
            if (!squeeze_in(arrangement)) return std::nullopt;
            return arrangement;
        }
        if (!is_free(problem_, arrangement, contacts_)) return std::nullopt;
        pull_home(problem_, arrangement, homes, contacts_);
        arrangement = calmly_grown(problem_, arrangement, homes, random_, budget_);
        arrangement = compacted(problem_, arrangement, contacts_, budget_);
        for (int round = 0; round < rounds_back; ++round) {
            pull_home(problem_, arrangement, homes, contacts_);
            grow_back(arrangement, wished_scales);
        }
        return arrangement;
    }

  private:
    /// The places of the items before any move, canvas px.
    std::vector<Vec2> start_places() {
        contacts_.set_scales(problem_.scales);
        std::vector<Vec2> starts(problem_.size());
        std::vector<bool> stands(problem_.size(), false);
        for (std::size_t i = 0; i < problem_.size(); ++i) {
            const PlanItem& item = request_.items[i];
            if (item.previous)
                starts[i] = problem_.shapes[i].centroid * item.previous->scale + item.previous->offset;
            else if (item.seat)
                starts[i] = item.seat->centre;
            stands[i] = item.previous || item.seat;
        }
        for (std::size_t i = 0; i < problem_.size(); ++i) {
            if (stands[i]) continue;
            starts[i] = roomiest_place(starts, stands, i);
            stands[i] = true;
        }
        return starts;
    }

    /// The place, among some random ones, where an item overlaps least with the placed items. px
    Vec2 roomiest_place(const std::vector<Vec2>& places, const std::vector<bool>& stands, std::size_t item) {
        constexpr int tries = 400;
        const Box range = problem_.place_range(item, 1);
        Vec2 best = range.centre();
        double smallest = -1;
        for (int k = 0; k < tries; ++k) {
            const Vec2 place = random_place(range, random_);
            double sum = 0;
            for (std::size_t j = 0; j < places.size(); ++j)
                if (stands[j]) sum += contacts_.depth(item, j, places[j] - place);
            budget_.spend();
            if (smallest >= 0 && sum >= smallest) continue;
            smallest = sum;
            best = place;
        }
        return best;
    }

    std::vector<Vec2> home_places(std::vector<Vec2> starts) const {
        for (std::size_t i = 0; i < problem_.size(); ++i) {
            const PlanItem& item = request_.items[i];
            if (item.home && item.previous && !problem_.pinned[i])
                starts[i] = problem_.shapes[i].centroid * item.home->scale + item.home->offset;
        }
        return starts;
    }

    bool has_newcomer() const {
        return std::any_of(request_.items.begin(), request_.items.end(),
                           [](const PlanItem& item) { return !item.previous; });
    }

    void shrink(double factor, Shrinking who, const Separation& separation) {
        std::vector<bool> gives(problem_.size(), who == Shrinking::all);
        if (who == Shrinking::colliding)
            for (const std::size_t i : separation.colliding())
                gives[i] = true;
        for (std::size_t i = 0; i < problem_.size(); ++i) {
            if (who == Shrinking::newcomers) gives[i] = !request_.items[i].previous;
            if (!gives[i] || problem_.pinned[i]) continue;
            const double least = who == Shrinking::all ? 0 : std::min(problem_.scales[i], fair_scales_[i]);
            problem_.scales[i] = std::max(least, problem_.scales[i] * factor);
        }
    }

    /// Shrinks first the newcomers, then the colliding items, both down to what is fair, then all.
    bool separate(Arrangement& arrangement, const std::vector<Vec2>& homes) {
        const SeparationStyle style = calm_style(homes);
        Separation separation(problem_, contacts_, random_);
        const std::vector<Vec2> starts = arrangement.places;
        constexpr int from_all = shrinks_of_newcomers + shrinks_of_colliding;
        const int first = has_newcomer() ? 0 : shrinks_of_newcomers;
        for (int k = first; k < from_all + shrinks_of_all && !budget_.is_spent(); ++k) {
            arrangement.places = starts;
            if (separation.run(arrangement, style, budget_, patience)) return true;
            const double common =
                first_common_shrink * std::pow(common_shrink_rise, std::max(0, k - from_all));
            if (k < shrinks_of_newcomers)
                shrink(newcomer_shrink, Shrinking::newcomers, separation);
            else if (k < from_all)
                shrink(colliding_shrink, Shrinking::colliding, separation);
            else
                shrink(1 - std::min(common, max_common_shrink), Shrinking::all, separation);
        }
        return false;
    }

    /// The last resort: kept items keep their place and scale; newcomers shrink until they fit between them.
    bool squeeze_in(Arrangement& arrangement) {
        constexpr double smaller = 0.8;
        constexpr int tries = 40;
        for (std::size_t i = 0; i < problem_.size(); ++i)
            if (request_.items[i].previous) {
                problem_.scales[i] = request_.items[i].previous->scale;
                problem_.limits[i] = std::max(problem_.limits[i], problem_.scales[i]);
            }
        for (int k = 0; k < tries; ++k) {
            if (is_free(problem_, arrangement, contacts_)) return true;
            for (std::size_t i = 0; i < problem_.size(); ++i) {
                if (request_.items[i].previous) continue;
                problem_.scales[i] *= smaller;
                push_aside(i, arrangement);
            }
        }
        return is_free(problem_, arrangement, contacts_);
    }

    /// Moves an item out of each of the others in turn.
    void push_aside(std::size_t item, Arrangement& arrangement) const {
        std::vector<Vec2>& places = arrangement.places;
        const Box range = problem_.place_range(item, arrangement.growth);
        for (std::size_t j = 0; j < problem_.size(); ++j) {
            const Vec2 way = j == item ? Vec2{} : contacts_.escape(j, item, places[item] - places[j]);
            places[item] = moved_into(places[item] + way, range);
        }
    }

    /// Lets items that shrank with all others grow again up to their wished scales, each at its place.
    void grow_back(Arrangement& arrangement, const std::vector<double>& wished_scales) {
        problem_.scales = scales_at(problem_, arrangement.growth);
        arrangement.growth = 1;
        contacts_.set_scales(problem_.scales);
        for (std::size_t i = 0; i < problem_.size(); ++i) {
            const double before = problem_.scales[i];
            if (problem_.pinned[i] || wished_scales[i] <= before) continue;
            problem_.scales[i] =
                std::max(before, max_free_scale(problem_, arrangement, contacts_, i, wished_scales[i]));
            if (problem_.keeps_order && !is_in_order(problem_, arrangement.places, 1))
                problem_.scales[i] = before;
            contacts_.set_scale(i, problem_.scales[i]);
        }
    }

    const PlanRequest& request_;  // outlives this
    PackingProblem& problem_;     // outlives this
    Random& random_;              // outlives this
    SearchBudget& budget_;        // outlives this
    Contacts contacts_;
    std::vector<double> fair_scales_;  // least fair scales
};

}  // namespace

std::optional<Arrangement> warm_start(const PlanRequest& request, PackingProblem& problem, Random& random,
                                      SearchBudget& budget) {
    return WarmStart(request, problem, random, budget).run();
}

}  // namespace vitrine::player
