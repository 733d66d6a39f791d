#include "player/layout/pack/arrangement.hpp"

#include "player/layout/pack/overlap.hpp"

#include <algorithm>
#include <limits>

namespace vitrine::player {

double PackingProblem::scale(std::size_t item, double growth) const {
    return pinned[item] ? scales[item] : std::min(scales[item] * growth, limits[item]);
}

GrowingScale PackingProblem::growing_scale(std::size_t item) const {
    if (pinned[item]) return {std::numeric_limits<double>::infinity(), scales[item]};
    return {scales[item], limits[item]};
}

Box PackingProblem::place_range(std::size_t item, double growth) const {
    if (pinned[item]) return {{-1e9, -1e9}, {1e9, 1e9}};
    const double s = scale(item, growth);
    return {field.min - shapes[item].extent.min * s, field.max - shapes[item].extent.max * s};
}

ReadingOrder reading_order(const PackingProblem& problem, double growth) {
    double sum = 0;
    for (std::size_t i = 0; i < problem.items(); ++i)
        sum += problem.shapes[i].extent.height() * problem.scale(i, growth);
    return {sum / (2 * static_cast<double>(problem.items()))};
}

Vec2 moved_into(Vec2 place, const Box& range) {
    return {std::max(range.min.x, std::min(place.x, range.max.x)),
            std::max(range.min.y, std::min(place.y, range.max.y))};
}

std::vector<double> scales_at(const PackingProblem& problem, double growth) {
    std::vector<double> scales;
    for (std::size_t i = 0; i < problem.size(); ++i)
        scales.push_back(problem.scale(i, growth));
    return scales;
}

bool is_free(const PackingProblem& problem, const Arrangement& arrangement, Contacts& contacts) {
    contacts.set_scales(scales_at(problem, arrangement.growth));
    const ReadingOrder order = reading_order(problem, arrangement.growth);
    for (std::size_t i = 0; i < problem.size(); ++i) {
        const Vec2 place = arrangement.places[i];
        const Box range = problem.place_range(i, arrangement.growth);
        const bool fits = range.max.x >= range.min.x - Contacts::precision &&
                          range.max.y >= range.min.y - Contacts::precision;
        if (!fits || length(moved_into(place, range) - place) > Contacts::precision) return false;
        for (std::size_t j = 0; j < i; ++j) {
            if (problem.pinned[i] && problem.pinned[j]) continue;  // both stay in place
            if (problem.keeps_order && i < problem.items() &&
                order.violation(arrangement.places[j], place) > Contacts::precision)
                return false;
            if (!contacts.is_clear(i, j, arrangement.places[j] - place)) return false;
        }
    }
    return true;
}

bool is_exactly_free(const PackingProblem& problem, const Arrangement& arrangement) {
    constexpr double rounding = 5e-6;  // px^2; where pinned shapes overlap, the sums are not exact
    std::vector<GridPolygon> pinned;
    std::vector<GridPolygon> all;
    for (std::size_t i = 0; i < problem.size(); ++i) {
        all.push_back(snapped(transformed(problem.shapes[i].outline, problem.scale(i, arrangement.growth),
                                          arrangement.places[i])));
        if (problem.pinned[i]) pinned.push_back(all.back());
    }
    const double allowed = UnionArea(std::move(pinned)).overlap();
    return UnionArea(std::move(all)).overlap() <= (allowed > 0 ? allowed + rounding : 0);
}

bool is_allowed_place(const PackingProblem& problem, const Contacts& contacts, const Arrangement& arrangement,
                      std::size_t item, Vec2 place) {
    if (!contacts.is_clear(item, place, arrangement.places)) return false;
    if (!problem.keeps_order) return true;
    const ReadingOrder order = reading_order(problem, arrangement.growth);
    for (std::size_t j = 0; j < problem.items(); ++j) {
        if (j == item) continue;
        const Vec2 other = arrangement.places[j];
        const double wrong = j < item ? order.violation(other, place) : order.violation(place, other);
        if (wrong > Contacts::precision) return false;
    }
    return true;
}

bool is_in_order(const PackingProblem& problem, const std::vector<Vec2>& places, double growth) {
    const ReadingOrder order = reading_order(problem, growth);
    for (std::size_t j = 0; j < problem.items(); ++j)
        for (std::size_t i = 0; i < j; ++i)
            if (!(problem.pinned[i] && problem.pinned[j]) &&
                order.violation(places[i], places[j]) > Contacts::precision)
                return false;
    return true;
}

namespace {

/// The largest scale at which the region of an item at this place fits into the field.
double scale_in_field(const PackingProblem& problem, std::size_t item, Vec2 place) {
    const Box& extent = problem.shapes[item].extent;
    const double max_scale = std::min(std::min((place.x - problem.field.min.x) / -extent.min.x,
                                               (problem.field.max.x - place.x) / extent.max.x),
                                      std::min((place.y - problem.field.min.y) / -extent.min.y,
                                               (problem.field.max.y - place.y) / extent.max.y));
    return std::max(0.0, max_scale);
}

double growth_in_field(const PackingProblem& problem, std::size_t item, Vec2 place) {
    const GrowingScale scale = problem.growing_scale(item);
    const double max_scale = scale_in_field(problem, item, place);
    return max_scale >= scale.limit ? std::numeric_limits<double>::infinity() : max_scale / scale.rate;
}

/// A growth in [min, max], near the largest, with the right order; 0: the order is wrong even at `min`.
double growth_in_order(const PackingProblem& problem, const std::vector<Vec2>& places, double min,
                       double max) {
    constexpr int halvings = 24;
    if (is_in_order(problem, places, max)) return max;
    if (!is_in_order(problem, places, min)) return 0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (min + max) / 2;
        (is_in_order(problem, places, middle) ? min : max) = middle;
    }
    return min;
}

}  // namespace

double max_free_scale(const PackingProblem& problem, const Arrangement& arrangement, const Contacts& contacts,
                      std::size_t item, double max) {
    const Vec2 place = arrangement.places[item];
    const GrowingScale growing{1, max};
    double scale = std::min(max, scale_in_field(problem, item, place));
    for (std::size_t j = 0; j < problem.size(); ++j) {
        if (j == item) continue;
        const GrowingScale stays{std::numeric_limits<double>::infinity(),
                                 problem.scale(j, arrangement.growth)};
        const Vec2 apart = arrangement.places[j] - place;
        scale = std::min(scale, contacts.max_clear_growth(item, j, apart, {growing, stays}, scale));
    }
    return scale;
}

double max_free_growth(const PackingProblem& problem, const Arrangement& arrangement,
                       const Contacts& contacts, double min, double max) {
    const std::vector<Vec2>& places = arrangement.places;
    for (std::size_t i = 0; i < problem.size(); ++i) {
        if (!problem.pinned[i]) max = std::min(max, growth_in_field(problem, i, places[i]));
        for (std::size_t j = 0; j < i && max >= min; ++j)
            if (!problem.pinned[i] || !problem.pinned[j])
                max = contacts.max_clear_growth(i, j, places[j] - places[i],
                                                {problem.growing_scale(i), problem.growing_scale(j)}, max);
    }
    if (max < min) return 0;
    return problem.keeps_order ? growth_in_order(problem, places, min, max) : max;
}

double final_growth(const PackingProblem& problem) {
    double growth = 0;
    for (std::size_t i = 0; i < problem.size(); ++i)
        if (!problem.pinned[i]) growth = std::max(growth, problem.limits[i] / problem.scales[i]);
    return growth;
}

double region_area(const PackingProblem& problem, double growth) {
    double sum = 0;
    for (std::size_t i = 0; i < problem.items(); ++i) {
        const double s = problem.scale(i, growth);
        sum += problem.shapes[i].area * s * s;
    }
    return sum;
}

}  // namespace vitrine::player
