#include "player/layout/arrangement.hpp"

#include <algorithm>

namespace vitrine {

double Ground::scale(std::size_t item, double growth) const {
    return pinned[item] ? scales[item] : std::min(scales[item] * growth, limits[item]);
}

Box Ground::range(std::size_t item, double growth) const {
    if (pinned[item]) return {{-1e9, -1e9}, {1e9, 1e9}};
    const double s = scale(item, growth);
    return {field.min - shapes[item].extent.min * s, field.max - shapes[item].extent.max * s};
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
    constexpr double tolerance = 1e-6;  // px, of places held at the edge of the field
    contacts.set_scales(scales_at(ground, arrangement.growth));
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const Vec2 place = arrangement.places[i];
        if (length(held(place, ground.range(i, arrangement.growth)) - place) > tolerance) return false;
        for (std::size_t j = 0; j < i; ++j) {
            if (ground.pinned[i] && ground.pinned[j]) continue;  // nothing can be done about those
            if (contacts.depth(i, j, arrangement.places[j] - place) > 0) return false;
        }
    }
    return true;
}

double greatest_growth(const Ground& ground, const Arrangement& arrangement, Contacts& contacts, double least,
                       double most) {
    constexpr int halvings = 24;
    Arrangement trial = arrangement;
    trial.growth = least;
    if (!is_free(ground, trial, contacts)) return 0;
    for (int i = 0; i < halvings; ++i) {
        trial.growth = (least + most) / 2;
        (is_free(ground, trial, contacts) ? least : most) = trial.growth;
    }
    return least;
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

}  // namespace vitrine
