#include "player/layout/warm_start.hpp"

#include "player/layout/optimizer.hpp"
#include "player/layout/separation.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {

namespace {

constexpr double most_apart = 2;  // of a scale and the natural one
constexpr double pull = 0.05;     // loss per px from home
constexpr int patience = 4;       // rounds of separation without less overlap
constexpr double newcomer_shrink = 0.93;
constexpr double common_shrink = 0.98;
constexpr int shrinks_of_newcomers = 6;
constexpr int shrinks_of_all = 40;

enum class Role { kept, seated, inserted };

Role role_of(const PlanItem& item) {
    if (item.previous) return Role::kept;
    return item.seat ? Role::seated : Role::inserted;
}

/// The growth at which natural scales are those that the kept items have: the median of the quotients.
double growth_of_kept(const PlanRequest& request, const Ground& ground) {
    std::vector<double> growths;
    for (std::size_t i = 0; i < ground.size(); ++i)
        if (request.items[i].previous) growths.push_back(request.items[i].previous->scale / ground.scales[i]);
    std::sort(growths.begin(), growths.end());
    return growths[growths.size() / 2];
}

/// Sets every scale for a growth of 1. Inserted items come on top, so all unpinned ones make room.
void set_scales(const PlanRequest& request, Ground& ground) {
    const double growth = growth_of_kept(request, ground);
    double kept_area = 0;
    double inserted_area = 0;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const PlanItem& item = request.items[i];
        const double natural = ground.scales[i] * growth;
        double scale = natural;
        if (item.previous)
            scale = item.previous->scale;
        else if (item.seat)
            scale = std::sqrt(item.seat->area / ground.shapes[i].area);
        if (!ground.pinned[i]) scale = std::clamp(scale, natural / most_apart, natural * most_apart);
        ground.scales[i] = ground.pinned[i] ? scale : std::min(scale, ground.limits[i]);
        const double area = ground.shapes[i].area * ground.scales[i] * ground.scales[i];
        (role_of(item) == Role::inserted ? inserted_area : kept_area) += area;
    }
    const double room = std::sqrt(kept_area / (kept_area + inserted_area));
    for (std::size_t i = 0; i < ground.size(); ++i)
        if (!ground.pinned[i]) ground.scales[i] *= room;
}

/// Of some random places, the one where an item overlaps the others least. px
Vec2 roomiest_place(const Ground& ground, const Contacts& contacts, const std::vector<Vec2>& places,
                    const std::vector<bool>& stands, std::size_t item, Random& random, Effort& effort) {
    constexpr int tries = 400;
    const Box range = ground.range(item, 1);
    Vec2 best = range.centre();
    double least = -1;
    for (int k = 0; k < tries; ++k) {
        const double x = uniform(random);
        const double y = uniform(random);
        const Vec2 place{range.min.x + x * (range.max.x - range.min.x),
                         range.min.y + y * (range.max.y - range.min.y)};
        double sum = 0;
        for (std::size_t j = 0; j < places.size(); ++j)
            if (stands[j]) sum += contacts.depth(item, j, places[j] - place);
        effort.spend();
        if (least >= 0 && sum >= least) continue;
        least = sum;
        best = place;
    }
    return best;
}

std::vector<Vec2> homes_of(const PlanRequest& request, const Ground& ground, Random& random, Effort& effort) {
    Contacts contacts(ground.shapes, ground.clearance);
    contacts.set_scales(ground.scales);
    std::vector<Vec2> homes(ground.size());
    std::vector<bool> stands(ground.size(), false);
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const PlanItem& item = request.items[i];
        if (item.previous)
            homes[i] = ground.shapes[i].centroid * item.previous->scale + item.previous->offset;
        else if (item.seat)
            homes[i] = item.seat->centre;
        stands[i] = role_of(item) != Role::inserted;
    }
    for (std::size_t i = 0; i < ground.size(); ++i) {
        if (stands[i]) continue;
        homes[i] = roomiest_place(ground, contacts, homes, stands, i, random, effort);
        stands[i] = true;
    }
    return homes;
}

void shrink(const PlanRequest& request, Ground& ground, double factor, bool newcomers_only) {
    for (std::size_t i = 0; i < ground.size(); ++i)
        if (!ground.pinned[i] && (!newcomers_only || !request.items[i].previous)) ground.scales[i] *= factor;
}

}  // namespace

std::optional<Arrangement> warm_start(const PlanRequest& request, Ground& ground, Random& random,
                                      Effort& effort) {
    set_scales(request, ground);
    const std::vector<Vec2> homes = homes_of(request, ground, random, effort);
    Contacts contacts(ground.shapes, ground.clearance);
    Separation separation(ground, contacts, random);
    const SeparationStyle style{.roams = false, .homes = homes, .pull = pull};
    Arrangement arrangement{homes, 1};
    bool is_separated = false;
    for (int k = 0; k < shrinks_of_newcomers + shrinks_of_all && !effort.is_spent(); ++k) {
        arrangement.places = homes;
        is_separated = separation.run(arrangement, style, effort, patience);
        if (is_separated) break;
        const bool newcomers_only = k < shrinks_of_newcomers;
        shrink(request, ground, newcomers_only ? newcomer_shrink : common_shrink, newcomers_only);
    }
    if (!is_separated || !is_free(ground, arrangement, contacts)) return std::nullopt;
    pull_home(ground, arrangement, homes, contacts);
    arrangement = calmly_grown(ground, arrangement, homes, random, effort);
    pull_home(ground, arrangement, homes, contacts);
    return arrangement;
}

}  // namespace vitrine
