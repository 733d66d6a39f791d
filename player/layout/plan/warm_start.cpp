#include "player/layout/plan/warm_start.hpp"

#include "player/layout/pack/compaction.hpp"
#include "player/layout/pack/optimizer.hpp"
#include "player/layout/pack/separation.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double most_apart = 2;  // of a scale and the natural one
constexpr double pull = 0.05;     // loss per px from home
constexpr int patience = 4;       // rounds of separation without less overlap
constexpr double newcomer_shrink = 0.93;
constexpr double first_common_shrink = 0.02;  // of the scale; each further one is larger
constexpr double common_shrink_rise = 1.35;
constexpr double most_common_shrink = 0.2;
constexpr int shrinks_of_newcomers = 6;
constexpr double colliding_shrink = 0.95;
constexpr int shrinks_of_colliding = 12;
constexpr int shrinks_of_all = 16;
constexpr int rounds_back = 3;  // home and to the old size

enum class Role { kept, seated, inserted };

Role role_of(const PlanItem& item) {
    if (item.previous) return Role::kept;
    return item.seat && item.seat->area > 0 ? Role::seated : Role::inserted;
}

/// The growth at which natural scales are those that the kept items have: the median of the quotients.
double growth_of_kept(const PlanRequest& request, const Ground& ground) {
    std::vector<double> growths;
    for (std::size_t i = 0; i < ground.size(); ++i)
        if (request.items[i].previous) growths.push_back(request.items[i].previous->scale / ground.scales[i]);
    std::sort(growths.begin(), growths.end());
    return growths[growths.size() / 2];
}

Placement home_of(const PlanItem& item) {
    return item.home.value_or(*item.previous);
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
            scale = ground.pinned[i] ? item.previous->scale : home_of(item).scale;
        else if (item.seat && item.seat->area > 0)
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

/// Where the items are before anything moves, canvas px.
std::vector<Vec2> starts_of(const PlanRequest& request, const Ground& ground, Contacts& contacts,
                            Random& random, Effort& effort) {
    contacts.set_scales(ground.scales);
    std::vector<Vec2> starts(ground.size());
    std::vector<bool> stands(ground.size(), false);
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const PlanItem& item = request.items[i];
        if (item.previous)
            starts[i] = ground.shapes[i].centroid * item.previous->scale + item.previous->offset;
        else if (item.seat)
            starts[i] = item.seat->centre;
        stands[i] = item.previous || item.seat;
    }
    for (std::size_t i = 0; i < ground.size(); ++i) {
        if (stands[i]) continue;
        starts[i] = roomiest_place(ground, contacts, starts, stands, i, random, effort);
        stands[i] = true;
    }
    return starts;
}

std::vector<Vec2> homes_of(const PlanRequest& request, const Ground& ground, std::vector<Vec2> starts) {
    for (std::size_t i = 0; i < ground.size(); ++i)
        if (const auto& home = request.items[i].home; home && request.items[i].previous && !ground.pinned[i])
            starts[i] = ground.shapes[i].centroid * home->scale + home->offset;
    return starts;
}

bool any_newcomer(const PlanRequest& request) {
    return std::any_of(request.items.begin(), request.items.end(),
                       [](const PlanItem& item) { return !item.previous; });
}

/// Who gives way where items cannot be separated.
enum class Giver { newcomers, colliding, all };

void shrink(const PlanRequest& request, Ground& ground, double factor, Giver giver,
            const Separation& separation) {
    std::vector<bool> gives(ground.size(), giver == Giver::all);
    if (giver == Giver::colliding)
        for (const std::size_t i : separation.colliding())
            gives[i] = true;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        if (giver == Giver::newcomers) gives[i] = !request.items[i].previous;
        if (gives[i] && !ground.pinned[i]) ground.scales[i] *= factor;
    }
}

/// Newcomers make themselves small, then those that are in each other's way, then all.
bool separated(const PlanRequest& request, Ground& ground, Arrangement& arrangement, Contacts& contacts,
               const SeparationStyle& style, Random& random, Effort& effort) {
    Separation separation(ground, contacts, random);
    const std::vector<Vec2> starts = arrangement.places;
    constexpr int from_all = shrinks_of_newcomers + shrinks_of_colliding;
    const int first = any_newcomer(request) ? 0 : shrinks_of_newcomers;
    for (int k = first; k < from_all + shrinks_of_all && !effort.is_spent(); ++k) {
        arrangement.places = starts;
        if (separation.run(arrangement, style, effort, patience)) return true;
        const double common = first_common_shrink * std::pow(common_shrink_rise, std::max(0, k - from_all));
        if (k < shrinks_of_newcomers)
            shrink(request, ground, newcomer_shrink, Giver::newcomers, separation);
        else if (k < from_all)
            shrink(request, ground, colliding_shrink, Giver::colliding, separation);
        else
            shrink(request, ground, 1 - std::min(common, most_common_shrink), Giver::all, separation);
    }
    return false;
}

/// The last resort: what stands keeps its place and scale, the newcomers are so small that they fit between.
bool squeezed_in(const PlanRequest& request, Ground& ground, Arrangement& arrangement, Contacts& contacts) {
    constexpr double smaller = 0.8;
    constexpr int tries = 40;
    for (std::size_t i = 0; i < ground.size(); ++i)
        if (request.items[i].previous) {
            ground.scales[i] = request.items[i].previous->scale;
            ground.limits[i] = std::max(ground.limits[i], ground.scales[i]);
        }
    for (int k = 0; k < tries; ++k) {
        if (is_free(ground, arrangement, contacts)) return true;
        for (std::size_t i = 0; i < ground.size(); ++i)
            if (!request.items[i].previous) {
                ground.scales[i] *= smaller;
                const Box range = ground.range(i, arrangement.growth);
                for (std::size_t j = 0; j < ground.size(); ++j) {
                    const Vec2 way =
                        j == i ? Vec2{}
                               : contacts.escape(j, i, arrangement.places[i] - arrangement.places[j]);
                    arrangement.places[i] = held(arrangement.places[i] + way, range);
                }
            }
    }
    return is_free(ground, arrangement, contacts);
}

/// What gave way as a whole becomes as large again as it wishes, each for itself where it stands.
void grow_back(Ground& ground, Arrangement& arrangement, const std::vector<double>& wishes,
               Contacts& contacts) {
    ground.scales = scales_at(ground, arrangement.growth);
    arrangement.growth = 1;
    contacts.set_scales(ground.scales);
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const double before = ground.scales[i];
        if (ground.pinned[i] || wishes[i] <= before) continue;
        ground.scales[i] = std::max(before, greatest_scale(ground, arrangement, contacts, i, wishes[i]));
        if (ground.reads && !is_in_order(ground, arrangement.places, 1)) ground.scales[i] = before;
        contacts.set_scale(i, ground.scales[i]);
    }
}

}  // namespace

std::optional<Arrangement> warm_start(const PlanRequest& request, Ground& ground, Random& random,
                                      Effort& effort) {
    set_scales(request, ground);
    const std::vector<double> wishes = ground.scales;
    Contacts contacts(ground.shapes, ground.clearance);
    const std::vector<Vec2> starts = starts_of(request, ground, contacts, random, effort);
    const std::vector<Vec2> homes = homes_of(request, ground, starts);
    const SeparationStyle style{.roams = false, .homes = homes, .pull = pull};
    Arrangement arrangement{starts, 1};
    if (!separated(request, ground, arrangement, contacts, style, random, effort)) {
        arrangement.places = starts;
        if (!squeezed_in(request, ground, arrangement, contacts)) return std::nullopt;
        return arrangement;
    }
    if (!is_free(ground, arrangement, contacts)) return std::nullopt;
    pull_home(ground, arrangement, homes, contacts);
    arrangement = calmly_grown(ground, arrangement, homes, random, effort);
    arrangement = compacted(ground, arrangement, contacts, effort);
    for (int round = 0; round < rounds_back; ++round) {
        pull_home(ground, arrangement, homes, contacts);
        grow_back(ground, arrangement, wishes, contacts);
    }
    return arrangement;
}

}  // namespace vitrine::player
