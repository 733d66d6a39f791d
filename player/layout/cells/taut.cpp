#include "player/layout/cells/taut.hpp"

#include "player/layout/cells/seam_bends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int rounds = 5;  // of pulling the seams and moving the junctions

/// The shortest way from the point before a bend to the one after it, round some corners in its triangle.
/// Without its ends.
Loop way_round(const Bend& bend, Loop corners) {
    Loop way;
    CellPoint here = bend.before;
    corners.push_back(bend.after);
    while (here != bend.after) {
        CellPoint next = corners[0];
        for (const CellPoint c : corners) {
            const std::int64_t off = bend.side * turn(here, next, c);
            if (off < 0 || (off == 0 && distance_between(here, c) > distance_between(here, next))) next = c;
        }
        if (next != bend.after) way.push_back(next);
        std::erase(corners, next);
        here = next;
    }
    return way;
}

/// Pulls one seam taut.
void pull(SeamField& field, std::size_t k) {
    Loop line = field.seam(k).line;
    std::size_t at = 1;
    for (std::size_t steps = 20 * line.size() + 100; at + 1 < line.size() && steps > 0; --steps) {
        const Bend bend(line[at - 1], line[at], line[at + 1]);
        Loop way;
        if (bend.side != 0) {
            if (field.is_crowded(bend, k, at)) {
                ++at;
                continue;
            }
            auto corners = field.corners_in(bend, field.seam(k));
            if (!corners) {
                ++at;
                continue;
            }
            way = way_round(bend, std::move(*corners));
        }
        const auto here = line.erase(line.begin() + static_cast<std::ptrdiff_t>(at));
        line.insert(here, way.begin(), way.end());
        field.replace(k, line);
        at = std::max<std::size_t>(at - 1, 1);
    }
}

/// The end of a seam in a junction.
struct SeamEnd {
    std::size_t seam = 0;
    bool is_front = false;
};

/// A junction that may move: of three items, or of two and the canvas' edge.
struct Junction {
    CellPoint home;              // its place at first
    double reach = 0;            // canvas px: it moves no farther from home
    std::vector<SeamEnd> ends;   // of movable seams
    std::vector<SeamEnd> edges;  // of the canvas' edge
};

/// The points of a seam in the direction away from a junction.
CellPoint point_from(const SeamField& field, const SeamEnd& end, std::size_t at) {
    const Loop& line = field.seam(end.seam).line;
    return end.is_front ? line[at] : line[line.size() - 1 - at];
}

CellPoint place_of(const SeamField& field, const Junction& junction) {
    return point_from(field, junction.ends[0], 0);
}

std::vector<Junction> junctions_of(const SeamField& field) {
    std::map<CellPoint, Junction> all;
    const auto add = [&](CellPoint at, const SeamEnd& end) {
        Junction& junction = all[at];
        (field.is_movable(end.seam) ? junction.ends : junction.edges).push_back(end);
    };
    for (std::size_t k = 0; k < field.size(); ++k) {
        add(field.seam(k).line.front(), {k, true});
        add(field.seam(k).line.back(), {k, false});
    }
    std::vector<Junction> found;
    for (auto& [at, junction] : all) {
        const bool is_inner = junction.ends.size() == 3 && junction.edges.empty();
        const bool is_outer = junction.ends.size() == 1 && junction.edges.size() == 2 &&
                              std::ranges::all_of(junction.edges, [&](const SeamEnd& end) {
                                  return field.seam(end.seam).right == no_owner;
                              });
        if (!is_inner && !is_outer) continue;
        junction.home = at;
        junction.reach = std::numeric_limits<double>::infinity();
        for (const SeamEnd& end : junction.ends) {
            const Loop& line = field.seam(end.seam).line;
            junction.reach = std::min(junction.reach, distance_between(line.front(), line.back()) / 2);
        }
        found.push_back(std::move(junction));
    }
    return found;
}

/// Moves junctions to where the ways from them are shortest.
class JunctionMoves {
  public:
    JunctionMoves(SeamField& field, const Junction& junction)
        : field_(field), junction_(junction), at_(place_of(field, junction)) {
        for (const SeamEnd& end : junction_.ends)
            for (const std::size_t owner : {field_.seam(end.seam).left, field_.seam(end.seam).right})
                if (std::ranges::find(owners_, owner) == owners_.end()) owners_.push_back(owner);
    }

    void run() {
        if (is_held()) return;
        if (junction_.edges.empty() && join_ways()) return;
        const Vec2 from = from_grid(at_);
        const Vec2 way = target() - from;
        for (const double share : {1.0, 0.5, 0.25}) {
            const CellPoint to = to_grid(from + way * share);
            if (to == at_ || !may_move(to)) continue;
            place(to);
            return;
        }
    }

  private:
    /// True if it lies on an outline's corner.
    bool is_held() const {
        return std::ranges::any_of(owners_, [&](std::size_t owner) {
            const Loop* outline = field_.outline_of(owner);
            return outline != nullptr && std::ranges::find(*outline, at_) != outline->end();
        });
    }

    /// If two seams go the same way at first, they meet at its end.
    bool join_ways() {
        for (std::size_t i = 0; i < 3; ++i) {
            const SeamEnd& a = junction_.ends[i];
            const SeamEnd& b = junction_.ends[(i + 1) % 3];
            const SeamEnd& third = junction_.ends[(i + 2) % 3];
            const CellPoint to = point_from(field_, a, 1);
            if (to != point_from(field_, b, 1) || a.seam == b.seam ||
                distance_between(junction_.home, to) > junction_.reach)
                continue;
            if (field_.seam(a.seam).line.size() < 3 || field_.seam(b.seam).line.size() < 3) continue;
            for (const SeamEnd& end : {a, b}) {
                Loop line = field_.seam(end.seam).line;
                line.erase(end.is_front ? line.begin() : line.end() - 1);
                field_.replace(end.seam, std::move(line));
            }
            Loop line = field_.seam(third.seam).line;
            line.insert(third.is_front ? line.begin() : line.end(), to);
            field_.replace(third.seam, std::move(line));
            return true;
        }
        return false;
    }

    Vec2 target() const {
        const Vec2 home = from_grid(junction_.home);
        Vec2 best = junction_.edges.empty() ? nearest_to_all() : foot_on_edge();
        const double way = length(best - home);
        if (way > junction_.reach) best = home + (best - home) * (junction_.reach / way);
        return best;
    }

    /// The point with the least sum of ways to the next bends (Weiszfeld's iteration).
    Vec2 nearest_to_all() const {
        constexpr int steps = 5;
        Vec2 point = from_grid(at_);
        for (int step = 0; step < steps; ++step) {
            Vec2 sum;
            double weights = 0;
            for (const SeamEnd& end : junction_.ends) {
                const Vec2 next = from_grid(point_from(field_, end, 1));
                const double weight = 1 / std::max(length(next - point), 1.0);
                sum = sum + next * weight;
                weights += weight;
            }
            point = sum * (1 / weights);
        }
        return point;
    }

    /// The point of the canvas' edge that is nearest to the next bend.
    Vec2 foot_on_edge() const {
        const CellPoint a = point_from(field_, junction_.edges[0], 1);
        const CellPoint b = point_from(field_, junction_.edges[1], 1);
        const CellPoint next = point_from(field_, junction_.ends[0], 1);
        const auto clamped = [](std::int64_t value, std::int64_t one, std::int64_t other) {
            constexpr auto apart = static_cast<std::int64_t>(cell_grid);  // one px from the next point
            const auto [low, high] = std::minmax(one, other);
            return high - low < 2 * apart ? (low + high) / 2 : std::clamp(value, low + apart, high - apart);
        };
        if (a.x == b.x && a.x == at_.x) return from_grid(CellPoint{at_.x, clamped(next.y, a.y, b.y)});
        if (a.y == b.y && a.y == at_.y) return from_grid(CellPoint{clamped(next.x, a.x, b.x), at_.y});
        return from_grid(at_);
    }

    bool may_move(CellPoint to) const {
        for (const std::size_t owner : owners_)
            if (!field_.has_pixels(owner, to)) return false;
        if (field_.is_crossed(at_, to, owners_)) return false;
        return std::ranges::all_of(junction_.ends, [&](const SeamEnd& end) {
            const CellPoint next = point_from(field_, end, 1);
            return next != to && !field_.is_crossed(to, next, owners_) &&
                   !field_.is_occupied(Bend(at_, to, next), owners_);
        });
    }

    void place(CellPoint to) {
        for (const auto* ends : {&junction_.ends, &junction_.edges})
            for (const SeamEnd& end : *ends) {
                Loop line = field_.seam(end.seam).line;
                (end.is_front ? line.front() : line.back()) = to;
                field_.replace(end.seam, std::move(line));
            }
    }

    SeamField& field_;          // outlives this
    const Junction& junction_;  // outlives this
    CellPoint at_;
    std::vector<std::size_t> owners_;
};

}  // namespace

void pull_taut(std::vector<Seam>& seams, const SeamLimits& limits) {
    SeamField field(seams, limits);
    const std::vector<Junction> junctions = junctions_of(field);
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t k = 0; k < field.size(); ++k)
            if (field.is_movable(k)) pull(field, k);
        if (round + 1 == rounds) break;
        for (const Junction& junction : junctions)
            JunctionMoves(field, junction).run();
    }
    for (std::size_t k = 0; k < field.size(); ++k)
        if (field.is_movable(k)) join_bends(field, k);
}

}  // namespace vitrine::player
