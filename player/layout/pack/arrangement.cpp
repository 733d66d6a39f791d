#include "player/layout/pack/arrangement.hpp"

#include "player/layout/pack/overlap.hpp"

#include <algorithm>
#include <limits>

namespace vitrine::player {

double Ground::scale(std::size_t item, double growth) const {
    return pinned[item] ? scales[item] : std::min(scales[item] * growth, limits[item]);
}

Growing Ground::growing(std::size_t item) const {
    if (pinned[item]) return {std::numeric_limits<double>::infinity(), scales[item]};
    return {scales[item], limits[item]};
}

Box Ground::range(std::size_t item, double growth) const {
    if (pinned[item]) return {{-1e9, -1e9}, {1e9, 1e9}};
    const double s = scale(item, growth);
    return {field.min - shapes[item].extent.min * s, field.max - shapes[item].extent.max * s};
}

ReadingOrder reading_order(const Ground& ground, double growth) {
    double sum = 0;
    for (std::size_t i = 0; i < ground.size(); ++i)
        sum += ground.shapes[i].extent.height() * ground.scale(i, growth);
    return {sum / (2 * static_cast<double>(ground.size()))};
}

Vec2 held(Vec2 place, const Box& range) {
    return {std::max(range.min.x, std::min(place.x, range.max.x)),
            std::max(range.min.y, std::min(place.y, range.max.y))};
}

std::vector<double> scales_at(const Ground& ground, double growth) {
    std::vector<double> scales;
    for (std::size_t i = 0; i < ground.size(); ++i)
        scales.push_back(ground.scale(i, growth));
    return scales;
}

bool is_free(const Ground& ground, const Arrangement& arrangement, Contacts& contacts) {
    contacts.set_scales(scales_at(ground, arrangement.growth));
    const ReadingOrder order = reading_order(ground, arrangement.growth);
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const Vec2 place = arrangement.places[i];
        const Box range = ground.range(i, arrangement.growth);
        const bool fits = range.max.x >= range.min.x - Contacts::precision &&
                          range.max.y >= range.min.y - Contacts::precision;
        if (!fits || length(held(place, range) - place) > Contacts::precision) return false;
        for (std::size_t j = 0; j < i; ++j) {
            if (ground.pinned[i] && ground.pinned[j]) continue;  // nothing can be done about those
            if (ground.reads && order.violation(arrangement.places[j], place) > Contacts::precision)
                return false;
            if (!contacts.is_clear(i, j, arrangement.places[j] - place)) return false;
        }
    }
    return true;
}

bool is_exactly_free(const Ground& ground, const Arrangement& arrangement) {
    std::vector<GridPolygon> pinned;
    std::vector<GridPolygon> all;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        all.push_back(snapped(transformed(ground.shapes[i].outline, ground.scale(i, arrangement.growth),
                                          arrangement.places[i])));
        if (ground.pinned[i]) pinned.push_back(all.back());
    }
    return UnionArea(std::move(all)).overlap() <= UnionArea(std::move(pinned)).overlap();
}

bool may_stand(const Ground& ground, const Contacts& contacts, const Arrangement& arrangement,
               std::size_t item, Vec2 place) {
    if (!contacts.is_clear(item, place, arrangement.places)) return false;
    if (!ground.reads) return true;
    const ReadingOrder order = reading_order(ground, arrangement.growth);
    for (std::size_t j = 0; j < ground.size(); ++j) {
        if (j == item) continue;
        const Vec2 other = arrangement.places[j];
        const double wrong = j < item ? order.violation(other, place) : order.violation(place, other);
        if (wrong > Contacts::precision) return false;
    }
    return true;
}

bool is_in_order(const Ground& ground, const std::vector<Vec2>& places, double growth) {
    const ReadingOrder order = reading_order(ground, growth);
    for (std::size_t j = 0; j < places.size(); ++j)
        for (std::size_t i = 0; i < j; ++i)
            if (!(ground.pinned[i] && ground.pinned[j]) &&
                order.violation(places[i], places[j]) > Contacts::precision)
                return false;
    return true;
}

namespace {

/// The most scale at which the region of an item fits into the field where it stands.
double scale_in_field(const Ground& ground, std::size_t item, Vec2 place) {
    const Box& extent = ground.shapes[item].extent;
    const double most = std::min(std::min((place.x - ground.field.min.x) / -extent.min.x,
                                          (ground.field.max.x - place.x) / extent.max.x),
                                 std::min((place.y - ground.field.min.y) / -extent.min.y,
                                          (ground.field.max.y - place.y) / extent.max.y));
    return std::max(0.0, most);
}

double growth_in_field(const Ground& ground, std::size_t item, Vec2 place) {
    const Growing scale = ground.growing(item);
    const double most = scale_in_field(ground, item, place);
    return most >= scale.limit ? std::numeric_limits<double>::infinity() : most / scale.rate;
}

/// A growth, near the most where it can be, at which the order holds; 0: it does not at the least.
double growth_in_order(const Ground& ground, const std::vector<Vec2>& places, double least, double most) {
    constexpr int halvings = 24;
    if (is_in_order(ground, places, most)) return most;
    if (!is_in_order(ground, places, least)) return 0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (least + most) / 2;
        (is_in_order(ground, places, middle) ? least : most) = middle;
    }
    return least;
}

}  // namespace

double greatest_scale(const Ground& ground, const Arrangement& arrangement, const Contacts& contacts,
                      std::size_t item, double most) {
    const Vec2 place = arrangement.places[item];
    const Growing growing{1, most};
    double scale = std::min(most, scale_in_field(ground, item, place));
    for (std::size_t j = 0; j < ground.size(); ++j) {
        if (j == item) continue;
        const Growing stays{std::numeric_limits<double>::infinity(), ground.scale(j, arrangement.growth)};
        const Vec2 apart = arrangement.places[j] - place;
        scale = std::min(scale, contacts.greatest_growth(item, j, apart, growing, stays, scale));
    }
    return scale;
}

double greatest_growth(const Ground& ground, const Arrangement& arrangement, const Contacts& contacts,
                       double least, double most) {
    const std::vector<Vec2>& places = arrangement.places;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        if (!ground.pinned[i]) most = std::min(most, growth_in_field(ground, i, places[i]));
        for (std::size_t j = 0; j < i && most >= least; ++j)
            if (!ground.pinned[i] || !ground.pinned[j])
                most = contacts.greatest_growth(i, j, places[j] - places[i], ground.growing(i),
                                                ground.growing(j), most);
    }
    if (most < least) return 0;
    return ground.reads ? growth_in_order(ground, places, least, most) : most;
}

double final_growth(const Ground& ground) {
    double growth = 0;
    for (std::size_t i = 0; i < ground.size(); ++i)
        if (!ground.pinned[i]) growth = std::max(growth, ground.limits[i] / ground.scales[i]);
    return growth;
}

double region_area(const Ground& ground, double growth) {
    double sum = 0;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const double s = ground.scale(i, growth);
        sum += ground.shapes[i].area * s * s;
    }
    return sum;
}

}  // namespace vitrine::player
