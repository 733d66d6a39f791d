#include "player/layout/pack/separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::player {

namespace {

constexpr int far_tries = 16;
constexpr int near_tries = 8;
constexpr std::size_t kept_candidates = 2;
constexpr double near_share = 0.08;  // share of the field's diagonal
constexpr double step_growth = 1.1;
constexpr double step_shrink = 0.5;
constexpr std::size_t items_a_move = 64;  // items looked at in the time of one evaluated move

}  // namespace

Vec2 random_place(const Box& range, Random& random) {
    const double x = uniform(random);
    const double y = uniform(random);
    return {range.min.x + x * (range.max.x - range.min.x), range.min.y + y * (range.max.y - range.min.y)};
}

Separation::Separation(const PackingProblem& problem, Contacts& contacts, Random& random)
    : problem_(problem), contacts_(contacts), random_(random), weights_(problem.size()) {}

double Separation::order_loss(std::size_t item, Vec2 place) {
    const std::span<const float> weight = weights_.row(item);
    double sum = 0;
    for (std::size_t j = 0; j < item; ++j)
        sum += weight[j] * order_->violation(places_.at(j), place);
    for (std::size_t j = item + 1; j < problem_.items(); ++j)
        sum += weight[j] * order_->violation(place, places_.at(j));
    return sum;
}

double Separation::loss(std::size_t item, Vec2 place, double enough) {
    budget_->spend(1 + static_cast<std::int64_t>(problem_.size() / items_a_move));
    double sum = 0;
    if (!style_->homes.empty()) sum = style_->pull * length(place - style_->homes[item]);
    if (order_) sum += order_loss(item, place);
    if (sum >= enough) return sum;
    return sum + contacts_.weighted_depth(item, place, places_, weights_.row(item), enough - sum);
}

/// The px that the items b < a need to be free of each other.
double Separation::conflict(std::size_t a, std::size_t b) const {
    const double depth = contacts_.depth(b, a, places_.at(a) - places_.at(b));
    const bool has_order = order_ && a < problem_.items();
    return has_order ? depth + order_->violation(places_.at(b), places_.at(a)) : depth;
}

/// Recomputes the conflicts of the items that moved.
void Separation::update_conflicts() {
    std::erase_if(conflicts_, [&](const Conflict& c) { return has_moved_[c.a] || has_moved_[c.b]; });
    const std::size_t n = problem_.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (!has_moved_[i]) continue;
        for (std::size_t j = 0; j < n; ++j) {
            if (j == i || (has_moved_[j] && j < i) || (problem_.pinned[i] && problem_.pinned[j])) continue;
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
        if (collides[i] && !problem_.pinned[i]) colliding_.push_back(i);
    has_moved_.assign(n, false);
}

void Separation::consider(std::size_t item, Vec2 place) {
    const bool full = best_.size() == kept_candidates;
    const Vec2 inside = moved_into(place, ranges_[item]);
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
    const Vec2 here = places_.at(item);
    for (std::size_t j = 0; j < problem_.size(); ++j) {
        if (j == item) continue;
        const Vec2 way = contacts_.escape(j, item, here - places_.at(j));
        if (way != Vec2{}) consider(item, here + way * (1 + 1e-6));
    }
    const double near = near_share * length(problem_.field.max - problem_.field.min);
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
            const Vec2 inside = moved_into(place, ranges_[item]);
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
    const double now = loss(item, places_.at(item), std::numeric_limits<double>::infinity());
    if (now == 0) return;
    best_.assign(1, {places_.at(item), now});
    propose(item);
    const double step = near_share / 4 * length(problem_.field.max - problem_.field.min);
    starts_ = best_;
    Candidate best{places_.at(item), now};
    for (const Candidate& start : starts_) {
        const Candidate end = refined(item, start, step);
        if (end.loss < best.loss) best = end;
    }
    if (best.loss == now) return;
    places_.set(item, best.place);
    has_moved_[item] = true;
}

bool Separation::run(Arrangement& arrangement, const SeparationStyle& style, SearchBudget& budget,
                     int patience) {
    style_ = &style;
    budget_ = &budget;
    contacts_.set_scales(scales_at(problem_, arrangement.growth));
    order_.reset();
    if (problem_.keeps_order) order_ = reading_order(problem_, arrangement.growth);
    weights_.reset();
    conflicts_.clear();
    has_moved_.assign(problem_.size(), true);
    ranges_.clear();
    for (std::size_t i = 0; i < problem_.size(); ++i) {
        ranges_.push_back(problem_.place_range(i, arrangement.growth));
        arrangement.places[i] = moved_into(arrangement.places[i], ranges_[i]);
    }
    places_.assign(arrangement.places);
    double smallest = std::numeric_limits<double>::infinity();
    update_conflicts();
    for (int idle = 0; !conflicts_.empty() && idle < patience && !budget.is_spent(); ++idle) {
        std::shuffle(colliding_.begin(), colliding_.end(), random_);
        for (const std::size_t item : colliding_)
            move(item);
        update_conflicts();
        weights_.update(conflicts_);
        if (total_ < smallest * 0.98) idle = -1;
        smallest = std::min(smallest, total_);
    }
    for (std::size_t i = 0; i < problem_.size(); ++i)
        if (!problem_.pinned[i]) arrangement.places[i] = moved_into(places_.at(i), ranges_[i]);
    return conflicts_.empty();
}

}  // namespace vitrine::player
