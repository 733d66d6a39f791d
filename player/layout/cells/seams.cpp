#include "player/layout/cells/seams.hpp"

#include "player/layout/cells/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <tuple>

namespace vitrine::player {

namespace {

constexpr std::int64_t one_point = 4;  // grid steps; points that are no farther apart are the same

/// Part of an outline, with its area on the left.
struct DirectedEdge {
    CellPoint from;
    CellPoint to;
    std::size_t owner = no_owner;

    bool operator<(const DirectedEdge& other) const {
        return std::tie(from, to, owner) < std::tie(other.from, other.to, other.owner);
    }
};

/// Makes points equal that are nearly equal, and puts those near the canvas' edge onto it.
class PointWelding {
  public:
    PointWelding(const std::vector<Loops>& areas, CellPoint far_corner) : far_(far_corner) {
        std::vector<CellPoint> points;
        for (const Loops& loops : areas)
            for (const Loop& loop : loops)
                for (const CellPoint p : loop)
                    points.push_back(on_edge(p));
        std::sort(points.begin(), points.end());
        points.erase(std::unique(points.begin(), points.end()), points.end());
        for (const CellPoint p : points)
            if (!known_near(p)) known_.push_back(p);
    }

    CellPoint welded(CellPoint point) const {
        const CellPoint p = on_edge(point);
        const CellPoint* near = known_near(p);
        return near == nullptr ? p : *near;
    }

  private:
    CellPoint on_edge(CellPoint p) const {
        if (std::abs(p.x) <= one_point) p.x = 0;
        if (std::abs(p.y) <= one_point) p.y = 0;
        if (std::abs(p.x - far_.x) <= one_point) p.x = far_.x;
        if (std::abs(p.y - far_.y) <= one_point) p.y = far_.y;
        return p;
    }

    const CellPoint* known_near(CellPoint p) const {
        const auto less = [](const CellPoint& c, std::int64_t x) { return c.x < x; };
        auto at = std::lower_bound(known_.begin(), known_.end(), p.x - one_point, less);
        for (; at != known_.end() && at->x <= p.x + one_point; ++at)
            if (std::abs(at->y - p.y) <= one_point) return &*at;
        return nullptr;
    }

    CellPoint far_;
    std::vector<CellPoint> known_;  // sorted
};

void weld(std::vector<Loops>& areas, CellPoint far_corner) {
    const PointWelding welding(areas, far_corner);
    std::vector<Loops*> all;
    for (Loops& loops : areas) {
        for (Loop& loop : loops)
            for (CellPoint& p : loop)
                p = welding.welded(p);
        all.push_back(&loops);
    }
    share_corners(all);
}

std::vector<DirectedEdge> edges_of(const std::vector<Loops>& areas) {
    std::vector<DirectedEdge> edges;
    for (std::size_t i = 0; i < areas.size(); ++i)
        for (const Loop& loop : areas[i])
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const CellPoint to = loop[(k + 1) % loop.size()];
                if (loop[k] != to) edges.push_back({loop[k], to, i});
            }
    std::sort(edges.begin(), edges.end());
    return edges;
}

/// A stretch between two areas, directed as a seam is.
struct SeamEdge {
    CellPoint from;
    CellPoint to;
    std::size_t left = no_owner;
    std::size_t right = no_owner;
    bool is_taken = false;
};

bool is_on_edge(const DirectedEdge& edge, CellPoint far) {
    return (edge.from.x == edge.to.x && (edge.from.x == 0 || edge.from.x == far.x)) ||
           (edge.from.y == edge.to.y && (edge.from.y == 0 || edge.from.y == far.y));
}

/// Pairs each edge with the one that runs the other way. None: one has no partner, or two.
std::optional<std::vector<SeamEdge>> paired(const std::vector<DirectedEdge>& edges, CellPoint far) {
    std::vector<SeamEdge> pairs;
    for (std::size_t k = 0; k < edges.size(); ++k) {
        const DirectedEdge& edge = edges[k];
        const auto is_same = [&](const DirectedEdge& e) { return e.from == edge.from && e.to == edge.to; };
        if (k + 1 < edges.size() && is_same(edges[k + 1])) return std::nullopt;
        const auto back = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{edge.to, edge.from, 0});
        if (back == edges.end() || back->from != edge.to || back->to != edge.from) {
            if (!is_on_edge(edge, far)) return std::nullopt;
            pairs.push_back({edge.from, edge.to, edge.owner, no_owner});
        } else if (edge.owner < back->owner) {
            pairs.push_back({edge.from, edge.to, edge.owner, back->owner});
        }
    }
    return pairs;
}

/// Joins edges to seams.
class SeamTracer {
  public:
    explicit SeamTracer(std::vector<SeamEdge> edges) : edges_(std::move(edges)) {
        for (std::size_t k = 0; k < edges_.size(); ++k) {
            at_[edges_[k].from].push_back(k);
            at_[edges_[k].to].push_back(k);
        }
    }

    std::vector<Seam> run() {
        std::vector<Seam> seams;
        for (SeamEdge& edge : edges_)
            if (!edge.is_taken && is_junction(edge.from)) seams.push_back(traced(edge));
        for (SeamEdge& edge : edges_)
            if (!edge.is_taken) seams.push_back(traced(edge));
        return seams;
    }

  private:
    bool is_junction(CellPoint point) const {
        const std::vector<std::size_t>& here = at_.at(point);
        if (here.size() != 2) return true;
        const SeamEdge& a = edges_[here[0]];
        const SeamEdge& b = edges_[here[1]];
        return a.left != b.left || a.right != b.right || (a.from == point) == (b.from == point);
    }

    Seam traced(SeamEdge& first) {
        Seam seam{first.left, first.right, {first.from, first.to}};
        first.is_taken = true;
        while (!is_junction(seam.line.back()) && seam.line.back() != seam.line.front()) {
            const std::vector<std::size_t>& here = at_.at(seam.line.back());
            SeamEdge& next = edges_[edges_[here[0]].is_taken ? here[1] : here[0]];
            next.is_taken = true;
            seam.line.push_back(next.to);
        }
        return seam;
    }

    std::vector<SeamEdge> edges_;
    std::map<CellPoint, std::vector<std::size_t>> at_;  // edges at each point
};

/// Joins the lines around one area to loops.
Loops joined_lines(std::vector<Loop> lines) {
    std::multimap<CellPoint, std::size_t> starts;
    for (std::size_t k = 0; k < lines.size(); ++k)
        starts.emplace(lines[k].front(), k);
    Loops loops;
    bool touches_itself = false;
    while (!starts.empty()) {
        Loop loop;
        auto at = starts.begin();
        while (at != starts.end()) {
            const Loop& line = lines[at->second];
            loop.insert(loop.end(), line.begin(), line.end() - 1);
            const CellPoint end = line.back();
            starts.erase(at);
            at = starts.find(end);
            touches_itself = touches_itself || starts.count(end) > 1;
        }
        if (loop.size() >= 3) loops.push_back(std::move(loop));
    }
    for (const Loop& loop : loops) {
        Loop sorted = loop;
        std::sort(sorted.begin(), sorted.end());
        touches_itself = touches_itself || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
    }
    return touches_itself ? union_of(loops, {}) : loops;
}

}  // namespace

std::optional<std::vector<Seam>> seams_of(std::vector<Loops> areas, const Box& canvas) {
    const CellPoint far = to_grid(canvas.max);
    weld(areas, far);
    auto edges = paired(edges_of(areas), far);
    if (!edges) return std::nullopt;
    return SeamTracer(std::move(*edges)).run();
}

std::vector<Loops> areas_of(std::span<const Seam> seams, std::size_t owners) {
    std::vector<std::vector<Loop>> lines(owners);
    for (const Seam& seam : seams) {
        if (seam.line.size() < 2 || (seam.line.size() == 2 && seam.line[0] == seam.line[1])) continue;
        if (seam.left != no_owner) lines[seam.left].push_back(seam.line);
        if (seam.right != no_owner) lines[seam.right].emplace_back(seam.line.rbegin(), seam.line.rend());
    }
    std::vector<Loops> areas;
    areas.reserve(lines.size());
    for (std::vector<Loop>& some : lines)
        areas.push_back(joined_lines(std::move(some)));
    return areas;
}

std::size_t bends_of(const Seam& seam) {
    std::size_t bends = 0;
    CellPoint before = seam.line.front();
    for (std::size_t k = 1; k + 1 < seam.line.size(); ++k) {
        const CellPoint p = seam.line[k];
        const CellPoint after = seam.line[k + 1];
        const Vec2 along = from_grid(after) - from_grid(before);
        const double off = std::abs(cross(along, from_grid(p) - from_grid(before)));
        constexpr double visible = 1.0 / 1024;  // canvas px
        if (off <= visible * length(along)) continue;
        ++bends;
        before = p;
    }
    return bends;
}

}  // namespace vitrine::player
