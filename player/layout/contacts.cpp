#include "player/layout/contacts.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace vitrine {

namespace {

// The clearance is added to each side, so it grows at the corners; sharper ones are cut off.
constexpr float corner_clearance = 3;
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Outward unit normals of a counter-clockwise outline, in the order of its edges.
std::vector<Vec2> normals(const Polygon& outline) {
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 edge = outline[(i + 1) % outline.size()] - outline[i];
        result.push_back(Vec2{edge.y, -edge.x} * (1 / length(edge)));
    }
    return result;
}

/// Supports of an outline along directions that turn the way its corners do: the corner that reaches
/// farthest moves on with them.
class TurningSupport {
  public:
    explicit TurningSupport(const Polygon& outline) : outline_(outline) {}

    double along(Vec2 direction) {
        if (is_first_) {
            for (std::size_t k = 1; k < outline_.size(); ++k)
                if (dot(outline_[k], direction) > dot(outline_[corner_], direction)) corner_ = k;
            is_first_ = false;
        }
        double reach = dot(outline_[corner_], direction);
        for (std::size_t k = 0; k < outline_.size(); ++k) {
            const std::size_t next = (corner_ + 1) % outline_.size();
            const double farther = dot(outline_[next], direction);
            if (farther < reach) break;
            reach = farther;
            corner_ = next;
        }
        return reach;
    }

  private:
    const Polygon& outline_;  // outlives this
    std::size_t corner_ = 0;
    bool is_first_ = true;
};

/// The most g at which two lengths that grow with g fit into the room together.
double growth_within(double room, Growing one, Growing other) {
    if (one.limit + other.limit <= room) return std::numeric_limits<double>::infinity();
    if (one.end() > other.end()) std::swap(one, other);
    const double both = room / (one.rate + other.rate);
    if (both <= one.end()) return both;
    return std::max(0.0, (room - one.limit) / other.rate);  // the one grows no more
}

}  // namespace

void Spots::assign(std::span<const Vec2> places) {
    x.resize(places.size());
    y.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        set(i, places[i]);
}

Contacts::Contacts(std::span<const Shape> shapes, double clearance)
    : size_(shapes.size()), clearance_(clearance), pairs_(size_ * size_), reach_squared_(size_ * size_, 0) {
    for (const Shape& shape : shapes)
        radii_.push_back(static_cast<float>(shape.radius));
    for (const Shape& shape : shapes)
        normals_.push_back(normals(shape.outline));
    sides_.reserve(size_ * size_ * 3);
    for (std::size_t a = 0; a < size_; ++a)
        for (std::size_t b = a + 1; b < size_; ++b)
            add_pair(a, b, shapes[a], shapes[b]);
}

void Contacts::add_pair(std::size_t a, std::size_t b, const Shape& first, const Shape& second) {
    pair_sides_.clear();
    TurningSupport along_second(second.outline);
    for (std::size_t k = 0; k < normals_[a].size(); ++k) {
        const Vec2 normal = normals_[a][k];
        pair_sides_.push_back({normal, dot(first.outline[k], normal), along_second.along(normal * -1)});
    }
    TurningSupport along_first(first.outline);
    for (std::size_t k = 0; k < normals_[b].size(); ++k) {
        const Vec2 normal = normals_[b][k] * -1;
        pair_sides_.push_back({normal, along_first.along(normal), dot(second.outline[k], normals_[b][k])});
    }
    const std::size_t begin = sides_.size();
    for (std::size_t k = 0; k < pair_sides_.size(); k += lanes) {
        Sides& sides = sides_.emplace_back();
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const Side& side = pair_sides_[std::min(k + lane, pair_sides_.size() - 1)];
            sides.x[lane] = static_cast<float>(side.normal.x);
            sides.y[lane] = static_cast<float>(side.normal.y);
            sides.first[lane] = static_cast<float>(side.first);
            sides.second[lane] = static_cast<float>(side.second);
        }
    }
    const Pair pair{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(sides_.size())};
    pairs_[a * size_ + b] = pairs_[b * size_ + a] = pair;
}

void Contacts::set_scales(std::span<const double> scales) {
    assert(scales.size() == size_);
    const auto clearance = static_cast<float>(clearance_);
    for (std::size_t a = 0; a < size_; ++a) {
        const auto first = static_cast<float>(scales[a]);
        for (std::size_t b = a + 1; b < size_; ++b) {
            const auto second = static_cast<float>(scales[b]);
            const Pair& p = pair(a, b);
            for (std::size_t k = p.begin; k < p.end; ++k)
                sides_[k].offset = sides_[k].first * first + sides_[k].second * second + clearance;
            const float reach = first * radii_[a] + second * radii_[b] + clearance * corner_clearance;
            reach_squared_[a * size_ + b] = reach_squared_[b * size_ + a] = reach * reach;
        }
    }
}

float Contacts::inside(const Pair& p, float x, float y) const {
    Lanes least = {infinity, infinity, infinity, infinity};
    for (std::size_t k = p.begin; k < p.end; ++k) {
        const Sides& sides = sides_[k];
        const Lanes depth = sides.offset - sides.x * x - sides.y * y;
        least = depth < least ? depth : least;
    }
    return std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
}

double Contacts::depth(std::size_t a, std::size_t b, Vec2 apart) const {
    const float turn = a < b ? 1.0F : -1.0F;
    const float x = turn * static_cast<float>(apart.x);
    const float y = turn * static_cast<float>(apart.y);
    if (is_far(a, b, x, y)) return 0;
    return std::max(0.0F, inside(pair(a, b), x, y));
}

bool Contacts::is_clear(std::size_t item, Vec2 place, std::span<const Vec2> places) const {
    for (std::size_t j = 0; j < places.size(); ++j)
        if (j != item && !is_clear(item, j, places[j] - place)) return false;
    return true;
}

double Contacts::weighted_depth(std::size_t item, Vec2 place, const Spots& spots,
                                std::span<const float> weights, double enough) const {
    const auto x = static_cast<float>(place.x);
    const auto y = static_cast<float>(place.y);
    const auto limit = static_cast<float>(std::min(enough, 1e30));
    float sum = 0;
    const auto add = [&](std::size_t j, float turn) {
        const float dx = turn * (spots.x[j] - x);
        const float dy = turn * (spots.y[j] - y);
        if (is_far(item, j, dx, dy)) return;
        const float depth = inside(pair(item, j), dx, dy);
        if (depth > 0) sum += weights[j] * depth;
    };
    for (std::size_t j = 0; j < item && sum < limit; ++j)
        add(j, -1.0F);
    for (std::size_t j = item + 1; j < size_ && sum < limit; ++j)
        add(j, 1.0F);
    return sum;
}

Hold Contacts::hold(std::size_t a, std::size_t b, Vec2 apart) const {
    const Pair& p = pair(a, b);
    const float turn = a < b ? 1.0F : -1.0F;
    const float x = turn * static_cast<float>(apart.x);
    const float y = turn * static_cast<float>(apart.y);
    Hold best{.slack = -std::numeric_limits<double>::infinity()};
    for (std::size_t k = p.begin; k < p.end; ++k) {
        const Sides& sides = sides_[k];
        const Lanes slack = sides.x * x + sides.y * y - sides.offset;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            if (slack[lane] <= best.slack) continue;
            best = {Vec2{sides.x[lane], sides.y[lane]} * turn, sides.first[lane], sides.second[lane],
                    slack[lane]};
            if (a > b) std::swap(best.first, best.second);
        }
    }
    return best;
}

Vec2 Contacts::escape(std::size_t a, std::size_t b, Vec2 apart) const {
    if (depth(a, b, apart) == 0) return {};
    const Hold best = hold(a, b, apart);
    return best.normal * -best.slack;
}

double Contacts::greatest_growth(std::size_t a, std::size_t b, Vec2 apart, Growing first,
                                 Growing second) const {
    if (a > b) return greatest_growth(b, a, apart * -1, second, first);
    const double far = first.limit * radii_[a] + second.limit * radii_[b] + clearance_ * corner_clearance;
    if (dot(apart, apart) >= far * far) return std::numeric_limits<double>::infinity();
    const Pair& p = pair(a, b);
    double most = 0;
    for (std::size_t k = p.begin; k < p.end; ++k)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const Sides& sides = sides_[k];
            const double room = sides.x[lane] * apart.x + sides.y[lane] * apart.y - clearance_;
            if (room <= 0) continue;
            most = std::max(
                most, growth_within(room, {first.rate * sides.first[lane], first.limit * sides.first[lane]},
                                    {second.rate * sides.second[lane], second.limit * sides.second[lane]}));
        }
    return most;
}

Stretch Contacts::blocked(std::size_t a, std::size_t b, Vec2 origin, Vec2 direction) const {
    const Pair& p = pair(a, b);
    const float turn = a < b ? 1.0F : -1.0F;
    const float x = turn * static_cast<float>(origin.x);
    const float y = turn * static_cast<float>(origin.y);
    const float to_x = turn * static_cast<float>(direction.x);
    const float to_y = turn * static_cast<float>(direction.y);
    Stretch inside{0, std::numeric_limits<double>::infinity()};
    for (std::size_t k = p.begin; k < p.end; ++k) {
        const Sides& sides = sides_[k];
        const Lanes speed = sides.x * to_x + sides.y * to_y;
        const Lanes room = sides.offset - sides.x * x - sides.y * y;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            if (speed[lane] == 0 && room[lane] <= 0) return {};
            const double limit = room[lane] / speed[lane];
            if (speed[lane] > 0) inside.end = std::min(inside.end, limit);
            if (speed[lane] < 0) inside.begin = std::max(inside.begin, limit);
        }
        if (inside.begin >= inside.end) return {};
    }
    return inside;
}

}  // namespace vitrine
