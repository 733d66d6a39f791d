#include "player/layout/separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine {

namespace {

constexpr int far_tries = 16;
constexpr int near_tries = 8;
constexpr std::size_t kept_candidates = 3;
constexpr double near_share = 0.08;   // of the field's diagonal
constexpr double finest_step = 0.02;  // canvas px
constexpr double step_growth = 1.1;
constexpr double step_shrink = 0.5;
constexpr double weight_decay = 0.95;
constexpr double least_rise = 1.2;  // of the weight of a colliding pair; the deepest rises by most_rise
constexpr double most_rise = 2.0;
constexpr double heaviest = 1e6;

Vec2 random_place(const Box& range, Random& random) {
    const double x = uniform(random);
    const double y = uniform(random);
    return {range.min.x + x * (range.max.x - range.min.x), range.min.y + y * (range.max.y - range.min.y)};
}

}  // namespace

Separation::Separation(const Ground& ground, Contacts& contacts, Random& random)
    : ground_(ground), contacts_(contacts), random_(random), weights_(ground.size() * ground.size(), 1) {}

double Separation::loss(std::size_t item, Vec2 place, double enough) {
    effort_->spend();
    double sum = 0;
    if (!style_->homes.empty()) sum = style_->pull * length(place - style_->homes[item]);
    for (std::size_t j = 0; j < places_.size() && sum < enough; ++j)
        if (j != item) sum += weight(item, j) * contacts_.depth(item, j, places_[j] - place);
    return sum;
}

std::vector<std::size_t> Separation::colliding() {
    std::vector<std::size_t> items;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (ground_.pinned[i]) continue;
        for (std::size_t j = 0; j < places_.size(); ++j)
            if (j != i && contacts_.depth(i, j, places_[j] - places_[i]) > 0) {
                items.push_back(i);
                break;
            }
    }
    return items;
}

double Separation::all_depths() {
    double sum = 0;
    for (std::size_t i = 0; i < places_.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            sum += contacts_.depth(i, j, places_[j] - places_[i]);
    return sum;
}

void Separation::consider(std::size_t item, Vec2 place) {
    const bool full = best_.size() == kept_candidates;
    const Vec2 inside = held(place, ranges_[item]);
    const double limit = full ? best_.back().loss : std::numeric_limits<double>::infinity();
    const Candidate candidate{inside, loss(item, inside, limit)};
    if (candidate.loss >= limit) return;
    if (full) best_.pop_back();
    const auto after =
        std::upper_bound(best_.begin(), best_.end(), candidate,
                         [](const Candidate& a, const Candidate& b) { return a.loss < b.loss; });
    best_.insert(after, candidate);
}

void Separation::propose(std::size_t item) {
    const Vec2 here = places_[item];
    for (std::size_t j = 0; j < places_.size(); ++j) {
        if (j == item) continue;
        const Vec2 way = contacts_.escape(j, item, here - places_[j]);
        if (way != Vec2{}) consider(item, here + way * (1 + 1e-9));
    }
    const double near = near_share * length(ground_.field.max - ground_.field.min);
    for (int i = 0; i < near_tries; ++i)
        consider(item, random_place({here - Vec2{near, near}, here + Vec2{near, near}}, random_));
    for (int i = 0; style_->roams && i < far_tries; ++i)
        consider(item, random_place(ranges_[item], random_));
}

Separation::Candidate Separation::refined(std::size_t item, Candidate start, double step) {
    constexpr Vec2 ways[] = {{1, 0}, {0, 1}, {0.7, 0.7}, {0.7, -0.7}};
    while (step > finest_step && start.loss > 0) {
        const Vec2 by = ways[uniform_index(random_, std::size(ways))] * step;
        bool better = false;
        for (const Vec2 place : {start.place + by, start.place - by}) {
            const Vec2 inside = held(place, ranges_[item]);
            const double there = loss(item, inside, start.loss);
            if (there >= start.loss) continue;
            start = {inside, there};
            better = true;
            break;
        }
        step *= better ? step_growth : step_shrink;
    }
    return start;
}

void Separation::move(std::size_t item) {
    const double now = loss(item, places_[item], std::numeric_limits<double>::infinity());
    best_.assign(1, {places_[item], now});
    propose(item);
    const double step = near_share / 4 * length(ground_.field.max - ground_.field.min);
    Candidate best{places_[item], now};
    for (const Candidate& start : std::vector<Candidate>(best_)) {
        const Candidate end = refined(item, start, step);
        if (end.loss < best.loss) best = end;
    }
    places_[item] = best.place;
}

void Separation::reweigh() {
    std::vector<double> depths(weights_.size());
    double deepest = 0;
    for (std::size_t i = 0; i < places_.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double depth = contacts_.depth(i, j, places_[j] - places_[i]);
            depths[i * places_.size() + j] = depth;
            deepest = std::max(deepest, depth);
        }
    for (std::size_t i = 0; i < places_.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double depth = depths[i * places_.size() + j];
            const double factor =
                depth > 0 ? least_rise + (most_rise - least_rise) * depth / deepest : weight_decay;
            const double changed = std::clamp(weight(i, j) * factor, 1.0, heaviest);
            weight(i, j) = weight(j, i) = changed;
        }
}

bool Separation::run(Arrangement& arrangement, const SeparationStyle& style, Effort& effort, int patience) {
    style_ = &style;
    effort_ = &effort;
    contacts_.set_scales(scales_at(ground_, arrangement.growth));
    std::fill(weights_.begin(), weights_.end(), 1.0);
    ranges_.clear();
    for (std::size_t i = 0; i < ground_.size(); ++i)
        ranges_.push_back(ground_.range(i, arrangement.growth));
    places_ = arrangement.places;
    for (std::size_t i = 0; i < ground_.size(); ++i)
        places_[i] = held(places_[i], ranges_[i]);
    double least = std::numeric_limits<double>::infinity();
    int idle = 0;  // rounds since the least total depth
    std::vector<std::size_t> items = colliding();
    while (!items.empty() && idle < patience && !effort.is_spent()) {
        std::shuffle(items.begin(), items.end(), random_);
        for (const std::size_t item : items)
            move(item);
        reweigh();
        const double total = all_depths();
        ++idle;
        if (total < least * 0.98) idle = 0;
        least = std::min(least, total);
        items = colliding();
    }
    arrangement.places = places_;
    return items.empty();
}

}  // namespace vitrine
