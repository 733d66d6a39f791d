#include "player/layout/pack/contacts.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

namespace vitrine::player {

namespace {

// The clearance is added to each side, so it is larger at the corners; at sharp corners it is cut off.
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

/// The supports of an outline along directions that turn in the order of its corners. The farthest corner
/// advances with them.
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

/// The largest g at which two lengths that grow with g fit into the room together.
double growth_within(double room, GrowingScale one, GrowingScale other) {
    if (one.limit + other.limit <= room) return std::numeric_limits<double>::infinity();
    if (one.end() > other.end()) std::swap(one, other);
    const double both = room / (one.rate + other.rate);
    if (both <= one.end()) return both;
    return std::max(0.0, (room - one.limit) / other.rate);  // the first length has reached its limit
}

}  // namespace

void PlaceLanes::assign(std::span<const Vec2> places) {
    constexpr float far_away = 1e15F;
    const std::size_t whole = (places.size() + 3) / 4 * 4;
    x.assign(whole, far_away);
    y.assign(whole, far_away);
    for (std::size_t i = 0; i < places.size(); ++i)
        set(i, places[i]);
}

Contacts::Contacts(std::span<const Shape> shapes, double clearance)
    : size_(shapes.size()),
      stride_((size_ + lanes - 1) / lanes * lanes),
      clearance_(clearance),
      scales_(size_, 1),
      reach_squared_(size_ * stride_, 0),
      pairs_(size_ * size_) {
    for (const Shape& shape : shapes) {
        outlines_.push_back(shape.outline);
        normals_.push_back(normals(shape.outline));
        radii_.push_back(static_cast<float>(shape.radius));
    }
}

void Contacts::add_pair(std::size_t a, std::size_t b) const {
    const Polygon& first = outlines_[a];
    const Polygon& second = outlines_[b];
    const std::size_t begin = sides_.size();
    std::size_t count = 0;
    const auto add_side = [&](Vec2 normal, double first_support, double second_support) {
        const std::size_t lane = count++ % lanes;
        if (lane == 0) sides_.emplace_back();
        Sides& sides = sides_.back();
        sides.x[lane] = static_cast<float>(normal.x);
        sides.y[lane] = static_cast<float>(normal.y);
        sides.first[lane] = static_cast<float>(first_support);
        sides.second[lane] = static_cast<float>(second_support);
    };
    TurningSupport along_second(second);
    for (std::size_t k = 0; k < normals_[a].size(); ++k) {
        const Vec2 normal = normals_[a][k];
        add_side(normal, dot(first[k], normal), along_second.along(normal * -1));
    }
    TurningSupport along_first(first);
    for (std::size_t k = 0; k < normals_[b].size(); ++k) {
        const Vec2 normal = normals_[b][k] * -1;
        add_side(normal, along_first.along(normal), dot(second[k], normals_[b][k]));
    }
    const Vec2 last = normals_[b].back() * -1;  // repeated, so that all lanes hold sides of the pair
    const double last_support = along_first.along(last);
    while (count % lanes != 0)
        add_side(last, last_support, dot(second[normals_[b].size() - 1], normals_[b].back()));
    const Pair pair{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(sides_.size())};
    pairs_[a * size_ + b] = pairs_[b * size_ + a] = pair;
    set_offsets(a, b, pair);
}

void Contacts::set_offsets(std::size_t a, std::size_t b, const Pair& pair) const {
    const auto clearance = static_cast<float>(clearance_);
    for (std::size_t k = pair.begin; k < pair.end; ++k)
        sides_[k].offset = sides_[k].first * scales_[a] + sides_[k].second * scales_[b] + clearance;
}

void Contacts::set_scales(std::span<const double> scales) {
    assert(scales.size() == size_);
    for (std::size_t i = 0; i < size_; ++i)
        scales_[i] = static_cast<float>(scales[i]);
    for (std::size_t a = 0; a < size_; ++a)
        for (std::size_t b = a + 1; b < size_; ++b)
            set_reach(a, b);
}

void Contacts::set_scale(std::size_t item, double scale) {
    scales_[item] = static_cast<float>(scale);
    for (std::size_t other = 0; other < size_; ++other)
        if (other != item) set_reach(std::min(item, other), std::max(item, other));
}

void Contacts::set_reach(std::size_t a, std::size_t b) {
    const float beyond = static_cast<float>(clearance_) * corner_clearance;
    const float reach = scales_[a] * radii_[a] + scales_[b] * radii_[b] + beyond;
    reach_squared_[a * stride_ + b] = reach_squared_[b * stride_ + a] = reach * reach;
    set_offsets(a, b, pairs_[a * size_ + b]);
}

float Contacts::signed_depth(const Pair& p, float x, float y) const {
    Lanes smallest = {infinity, infinity, infinity, infinity};
    for (std::size_t k = p.begin; k < p.end; ++k) {
        const Sides& sides = sides_[k];
        const Lanes depth = sides.offset - sides.x * x - sides.y * y;
        smallest = depth < smallest ? depth : smallest;
    }
    return std::min(std::min(smallest[0], smallest[1]), std::min(smallest[2], smallest[3]));
}

double Contacts::depth(std::size_t a, std::size_t b, Vec2 apart) const {
    const float turn = a < b ? 1.0F : -1.0F;
    const float x = turn * static_cast<float>(apart.x);
    const float y = turn * static_cast<float>(apart.y);
    if (is_far(a, b, x, y)) return 0;
    return std::max(0.0F, signed_depth(pair(a, b), x, y));
}

bool Contacts::is_clear(std::size_t item, Vec2 place, std::span<const Vec2> places) const {
    for (std::size_t j = 0; j < places.size(); ++j)
        if (j != item && !is_clear(item, j, places[j] - place)) return false;
    return true;
}

double Contacts::weighted_depth(std::size_t item, Vec2 place, const PlaceLanes& places,
                                std::span<const float> weights, double enough) const {
    using Mask = std::int32_t __attribute__((vector_size(16)));
    const auto x = static_cast<float>(place.x);
    const auto y = static_cast<float>(place.y);
    const float* reach = reach_squared_.data() + item * stride_;
    double sum = 0;
    for (std::size_t j = 0; j < stride_; j += lanes) {
        Lanes to_x, to_y, reaches;
        std::memcpy(&to_x, places.x.data() + j, sizeof(Lanes));
        std::memcpy(&to_y, places.y.data() + j, sizeof(Lanes));
        std::memcpy(&reaches, reach + j, sizeof(Lanes));
        to_x -= x;
        to_y -= y;
        const Mask near = to_x * to_x + to_y * to_y < reaches;  // excludes the item itself: its reach is 0
        if ((near[0] | near[1] | near[2] | near[3]) == 0) continue;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            if (near[lane] == 0) continue;
            const std::size_t other = j + lane;
            const float turn = item < other ? 1.0F : -1.0F;
            const float depth = signed_depth(pair(item, other), turn * to_x[lane], turn * to_y[lane]);
            if (depth > 0) sum += static_cast<double>(weights[other] * depth);
        }
        if (sum >= enough) break;
    }
    return sum;
}

SeparatingSide Contacts::separating_side(std::size_t a, std::size_t b, Vec2 apart) const {
    const Pair& p = pair(a, b);
    const float turn = a < b ? 1.0F : -1.0F;
    const float x = turn * static_cast<float>(apart.x);
    const float y = turn * static_cast<float>(apart.y);
    SeparatingSide best{.slack = -std::numeric_limits<double>::infinity()};
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
    const SeparatingSide best = separating_side(a, b, apart);
    return best.normal * -best.slack;
}

double Contacts::max_clear_growth(std::size_t a, std::size_t b, Vec2 apart, const GrowingScales& scales,
                                  double max) const {
    const auto& [first, second] = scales;
    if (a > b) return max_clear_growth(b, a, apart * -1, {second, first}, max);
    const double far = first.at(max) * radii_[a] + second.at(max) * radii_[b] + clearance_ * corner_clearance;
    if (dot(apart, apart) >= far * far) return max;
    const Pair& p = pair(a, b);
    double growth = 0;
    for (std::size_t k = p.begin; k < p.end; ++k)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const Sides& sides = sides_[k];
            const double room = sides.x[lane] * apart.x + sides.y[lane] * apart.y - clearance_;
            if (room <= 0) continue;
            growth = std::max(growth, growth_within(room, first.times(sides.first[lane]),
                                                    second.times(sides.second[lane])));
        }
    return std::min(growth, max);
}

RayStretch Contacts::blocked_stretch(std::size_t a, std::size_t b, Vec2 origin, Vec2 direction) const {
    const double aside = cross(direction, origin);
    if (aside * aside >= static_cast<double>(reach_squared_[a * stride_ + b]) * dot(direction, direction))
        return {};
    const Pair& p = pair(a, b);
    const float turn = a < b ? 1.0F : -1.0F;
    const float x = turn * static_cast<float>(origin.x);
    const float y = turn * static_cast<float>(origin.y);
    const float to_x = turn * static_cast<float>(direction.x);
    const float to_y = turn * static_cast<float>(direction.y);
    const Lanes never = {infinity, infinity, infinity, infinity};
    Lanes begins = {};
    Lanes ends = never;
    for (std::size_t k = p.begin; k < p.end; ++k) {
        const Sides& sides = sides_[k];
        const Lanes speed = sides.x * to_x + sides.y * to_y;
        const Lanes room = sides.offset - sides.x * x - sides.y * y;
        const Lanes along = room > 0 ? never : -never;  // the ray is parallel to the side
        const Lanes crossing = speed == 0 ? along : room / speed;
        const Lanes in = speed < 0 ? crossing : begins;
        const Lanes out = speed < 0 ? ends : crossing;
        begins = in > begins ? in : begins;
        ends = out < ends ? out : ends;
    }
    RayStretch inside{begins[0], ends[0]};
    for (std::size_t lane = 1; lane < lanes; ++lane) {
        inside.begin = std::max(inside.begin, static_cast<double>(begins[lane]));
        inside.end = std::min(inside.end, static_cast<double>(ends[lane]));
    }
    return inside.begin < inside.end ? inside : RayStretch{};
}

}  // namespace vitrine::player
