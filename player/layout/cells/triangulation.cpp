#include "player/layout/cells/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>

namespace vitrine::player {

namespace {

bool is_in_triangle(CellPoint p, CellPoint a, CellPoint b, CellPoint c) {
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

constexpr std::int64_t near_enough = 2;  // grid steps

/// True if a loop is so narrow that no pixel lies in it.
bool is_needle(const Loop& loop) {
    double around = 0;  // grid steps
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const CellPoint next = loop[(k + 1) % loop.size()];
        around +=
            std::hypot(static_cast<double>(next.x - loop[k].x), static_cast<double>(next.y - loop[k].y));
    }
    return std::abs(twice_area(loop)) <= static_cast<double>(near_enough) * around;
}

/// An outline without the needles that begin and end at one of its corners. Ears beside a needle could lie
/// outside of the outline.
Loop without_needles(const Loop& outline) {
    for (auto first = outline.begin(); first != outline.end(); ++first)
        for (auto again = std::find(std::next(first), outline.end(), *first); again != outline.end();
             again = std::find(std::next(again), outline.end(), *first)) {
            const Loop inside(first, again);
            Loop rest(again, outline.end());
            rest.insert(rest.end(), outline.begin(), first);
            if (is_needle(inside)) return without_needles(rest);
            if (is_needle(rest)) return without_needles(inside);
        }
    return outline;
}

/// Cuts ears off an outline until nothing is left.
class EarClipping {
  public:
    explicit EarClipping(const Loop& outline) : left_(outline) {}

    std::vector<GridTriangle> run() {
        std::size_t at = 0;
        std::size_t tried = 0;
        while (left_.size() >= 3) {
            at %= left_.size();
            if (tried >= left_.size()) {
                if (area() <= 0) break;
                drop_flattest();
                tried = 0;
                continue;
            }
            if (is_ear(at)) {
                clip(at);
                tried = 0;
                ++at;  // a second ear at the same corner would make thin fans
                continue;
            }
            ++at;
            ++tried;
        }
        return std::move(triangles_);
    }

  private:
    CellPoint corner(std::size_t at) const { return left_[at % left_.size()]; }

    bool is_ear(std::size_t at) const {
        const CellPoint a = corner(at + left_.size() - 1);
        const CellPoint b = corner(at);
        const CellPoint c = corner(at + 1);
        if (turn(a, b, c) <= 0) return false;
        for (const CellPoint p : left_)
            if (p != a && p != b && p != c && is_in_triangle(p, a, b, c)) return false;
        return true;
    }

    /// Twice the area that is left, grid steps^2.
    std::int64_t area() const {
        std::int64_t sum = 0;
        for (std::size_t k = 1; k + 1 < left_.size(); ++k)
            sum += turn(left_.front(), left_[k], left_[k + 1]);
        return sum;
    }

    /// Corners that neighbours share may lie a step or two beyond a side, so that an outline crosses itself
    /// and has no ear. The flattest corner is where.
    void drop_flattest() {
        const auto flatness = [&](std::size_t at) {
            return std::abs(turn(corner(at + left_.size() - 1), corner(at), corner(at + 1)));
        };
        std::size_t flattest = 0;
        for (std::size_t k = 1; k < left_.size(); ++k)
            if (flatness(k) < flatness(flattest)) flattest = k;
        if (turn(corner(flattest + left_.size() - 1), corner(flattest), corner(flattest + 1)) > 0)
            return clip(flattest);
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(flattest));
    }

    void clip(std::size_t at) {
        triangles_.push_back({corner(at + left_.size() - 1), corner(at), corner(at + 1)});
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
        // Two equal corners in a row enclose no area between them: one is removed.
        for (std::size_t k = 0; k < left_.size() && left_.size() >= 3; ++k)
            if (corner(k) == corner(k + 1)) left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(k));
    }

    Loop left_;
    std::vector<GridTriangle> triangles_;
};

/// The position of a point along the side a -> b, in (0, 1); negative if the point is not on the side.
double place_on_side(CellPoint p, CellPoint a, CellPoint b) {
    if (p == a || p == b) return -1;
    if (p.x < std::min(a.x, b.x) - near_enough || p.x > std::max(a.x, b.x) + near_enough ||
        p.y < std::min(a.y, b.y) - near_enough || p.y > std::max(a.y, b.y) + near_enough)
        return -1;
    const auto dx = static_cast<double>(b.x - a.x);
    const auto dy = static_cast<double>(b.y - a.y);
    const double squared = dx * dx + dy * dy;
    const double off = static_cast<double>(turn(a, b, p));
    if (off * off > static_cast<double>(near_enough * near_enough) * squared) return -1;
    const double along =
        (static_cast<double>(p.x - a.x) * dx + static_cast<double>(p.y - a.y) * dy) / squared;
    return along > 0 && along < 1 ? along : -1;
}

Loop with_corners(const Loop& loop, const std::vector<CellPoint>& corners) {
    Loop result;
    std::vector<std::pair<double, CellPoint>> on_side;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const CellPoint a = loop[k];
        const CellPoint b = loop[(k + 1) % loop.size()];
        result.push_back(a);
        on_side.clear();
        const std::int64_t from = std::min(a.x, b.x) - near_enough;
        const std::int64_t to = std::max(a.x, b.x) + near_enough;
        auto p = std::lower_bound(corners.begin(), corners.end(), from,
                                  [](const CellPoint& c, std::int64_t x) { return c.x < x; });
        for (; p != corners.end() && p->x <= to; ++p) {
            const double along = place_on_side(*p, a, b);
            if (along > 0) on_side.emplace_back(along, *p);
        }
        std::sort(on_side.begin(), on_side.end());
        for (const auto& [along, point] : on_side)
            result.push_back(point);
    }
    return result;
}

}  // namespace

std::vector<GridTriangle> triangulated(const Loop& outline) {
    return EarClipping(without_needles(outline)).run();
}

void share_corners(const std::vector<Loops*>& loops) {
    std::vector<CellPoint> corners;
    for (const Loops* some : loops)
        for (const Loop& loop : *some)
            corners.insert(corners.end(), loop.begin(), loop.end());
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (Loops* some : loops)
        for (Loop& loop : *some)
            loop = with_corners(loop, corners);
}

}  // namespace vitrine::player
