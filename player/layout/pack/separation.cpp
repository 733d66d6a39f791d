#include "player/layout/pack/separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::player {

namespace {

constexpr int far_tries = 16;
constexpr int near_tries = 8;
constexpr std::size_t kept_candidates = 2;
constexpr double near_share = 0.08;  // of the field's diagonal
constexpr double step_growth = 1.1;
constexpr double step_shrink = 0.5;
constexpr double weight_decay = 0.95;
constexpr double least_rise = 1.2;  // of the weight of a colliding pair; the deepest rises by most_rise
constexpr double most_rise = 2.0;
constexpr std::size_t items_a_move = 64;  // looked through in the time of an evaluated move
constexpr float heaviest = 1e6F;

}  // namespace

Vec2 random_place(const Box& range, Random& random) {
    const double x = uniform(random);
    const double y = uniform(random);
    return {range.min.x + x * (range.max.x - range.min.x), range.min.y + y * (range.max.y - range.min.y)};
}

Separation::Separation(const Ground& ground, Contacts& contacts, Random& random)
    : ground_(ground), contacts_(contacts), random_(random), weights_(ground.size() * ground.size(), 1) {}

double Separation::order_loss(std::size_t item, Vec2 place) {
    const std::span<const float> weight = weights(item);
    double sum = 0;
    for (std::size_t j = 0; j < item; ++j)
        sum += weight[j] * order_->violation(spots_.at(j), place);
    for (std::size_t j = item + 1; j < ground_.size(); ++j)
        sum += weight[j] * order_->violation(place, spots_.at(j));
    return sum;
}

double Separation::loss(std::size_t item, Vec2 place, double enough) {
    effort_->spend(1 + static_cast<std::int64_t>(ground_.size() / items_a_move));
    double sum = 0;
    if (!style_->homes.empty()) sum = style_->pull * length(place - style_->homes[item]);
    if (order_) sum += order_loss(item, place);
    if (sum >= enough) return sum;
    return sum + contacts_.weighted_depth(item, place, spots_, weights(item), enough - sum);
}

/// What keeps items b < a from being free of each other.
double Separation::conflict(std::size_t a, std::size_t b) const {
    const double depth = contacts_.depth(b, a, spots_.at(a) - spots_.at(b));
    return order_ ? depth + order_->violation(spots_.at(b), spots_.at(a)) : depth;
}

/// Finds anew the conflicts of the items that moved.
void Separation::update_conflicts() {
    std::erase_if(conflicts_, [&](const Conflict& c) { return has_moved_[c.a] || has_moved_[c.b]; });
    const std::size_t n = ground_.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (!has_moved_[i]) continue;
        for (std::size_t j = 0; j < n; ++j) {
            if (j == i || (has_moved_[j] && j < i) || (ground_.pinned[i] && ground_.pinned[j])) continue;
            const auto [less, more] = std::minmax(i, j);
            const double found = conflict(more, less);
            if (found > 0) conflicts_.push_back({more, less, found});
        }
    }
    total_ = 0;
    std::vector<bool> collides(n, false);
    for (const Conflict& c : conflicts_) {
        total_ += c.size;
        collides[c.a] = collides[c.b] = true;
    }
    colliding_.clear();
    for (std::size_t i = 0; i < n; ++i)
        if (collides[i] && !ground_.pinned[i]) colliding_.push_back(i);
    has_moved_.assign(n, false);
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
    const Vec2 here = spots_.at(item);
    for (std::size_t j = 0; j < ground_.size(); ++j) {
        if (j == item) continue;
        const Vec2 way = contacts_.escape(j, item, here - spots_.at(j));
        if (way != Vec2{}) consider(item, here + way * (1 + 1e-6));
    }
    const double near = near_share * length(ground_.field.max - ground_.field.min);
    for (int i = 0; i < near_tries; ++i)
        consider(item, random_place({here - Vec2{near, near}, here + Vec2{near, near}}, random_));
    for (int i = 0; style_->roams && i < far_tries; ++i)
        consider(item, random_place(ranges_[item], random_));
}

Separation::Candidate Separation::refined(std::size_t item, Candidate start, double step) {
    constexpr Vec2 ways[] = {{1, 0}, {0, 1}, {0.7, 0.7}, {0.7, -0.7}};
    while (step > style_->finest_step && start.loss > 0) {
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
    const double now = loss(item, spots_.at(item), std::numeric_limits<double>::infinity());
    if (now == 0) return;
    best_.assign(1, {spots_.at(item), now});
    propose(item);
    const double step = near_share / 4 * length(ground_.field.max - ground_.field.min);
    starts_ = best_;
    Candidate best{spots_.at(item), now};
    for (const Candidate& start : starts_) {
        const Candidate end = refined(item, start, step);
        if (end.loss < best.loss) best = end;
    }
    if (best.loss == now) return;
    spots_.set(item, best.place);
    has_moved_[item] = true;
}

/// Raises the weights of the pairs that conflict, lowers those of the others that had been raised.
void Separation::reweigh() {
    double largest = 0;
    for (const Conflict& c : conflicts_)
        largest = std::max(largest, c.size);
    for (const Conflict& c : conflicts_) {
        if (weights(c.a)[c.b] == 1) raised_.push_back({c.a, c.b});
        const double factor = least_rise + (most_rise - least_rise) * c.size / largest;
        weights(c.a)[c.b] *= static_cast<float>(factor / weight_decay);  // it decays with the others
    }
    std::erase_if(raised_, [&](const std::pair<std::size_t, std::size_t>& pair) {
        const float lowered = weights(pair.first)[pair.second] * static_cast<float>(weight_decay);
        const float weight = std::clamp(lowered, 1.0F, heaviest);
        weights(pair.first)[pair.second] = weights(pair.second)[pair.first] = weight;
        return weight == 1;
    });
}

bool Separation::run(Arrangement& arrangement, const SeparationStyle& style, Effort& effort, int patience) {
    style_ = &style;
    effort_ = &effort;
    contacts_.set_scales(scales_at(ground_, arrangement.growth));
    order_.reset();
    if (ground_.reads) order_ = reading_order(ground_, arrangement.growth);
    std::fill(weights_.begin(), weights_.end(), 1.0F);
    raised_.clear();
    conflicts_.clear();
    has_moved_.assign(ground_.size(), true);
    ranges_.clear();
    for (std::size_t i = 0; i < ground_.size(); ++i) {
        ranges_.push_back(ground_.range(i, arrangement.growth));
        arrangement.places[i] = held(arrangement.places[i], ranges_[i]);
    }
    spots_.assign(arrangement.places);
    double least = std::numeric_limits<double>::infinity();
    update_conflicts();
    for (int idle = 0; !conflicts_.empty() && idle < patience && !effort.is_spent(); ++idle) {
        std::shuffle(colliding_.begin(), colliding_.end(), random_);
        for (const std::size_t item : colliding_)
            move(item);
        update_conflicts();
        reweigh();
        if (total_ < least * 0.98) idle = -1;
        least = std::min(least, total_);
    }
    for (std::size_t i = 0; i < ground_.size(); ++i)
        if (!ground_.pinned[i]) arrangement.places[i] = held(spots_.at(i), ranges_[i]);
    return conflicts_.empty();
}

}  // namespace vitrine::player
