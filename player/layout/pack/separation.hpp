#pragma once

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/pair_weights.hpp"
#include "player/layout/pack/reading_order.hpp"
#include "player/layout/pack/search_budget.hpp"

#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// The rules for moving items during separation.
struct SeparationStyle {
    bool roams = true;          // tries places on the whole field, not only near the item
    std::vector<Vec2> homes;    // canvas px, preferred places; empty: none
    double pull = 0;            // loss per px of distance from home, relative to a px of depth
    double finest_step = 0.02;  // canvas px, last step of a refinement
};

/// A random place, uniform in a box.
Vec2 random_place(const Box& range, Random& random);

/// Separates overlapping items at one growth: guided local search.
///
/// The loss is the sum over all pairs of weight times depth. A colliding item moves to the best of several
/// places: some in its whole range, some near it, and for each neighbour the place that clears it of that
/// one. The best are refined along the axes. If the order matters, the distance to a place in order is added
/// to the depth.
/// Source: docs/algorithms.md, (d) "Escaping minima"; the idea is that of sparrow (arXiv
/// 2509.13329, algorithms 9 and 11). Differs: the exact penetration depth of convex shapes instead of a proxy
/// by circles.
class Separation {
  public:
    /// Both are borrowed and must outlive this.
    Separation(const PackingProblem& problem, Contacts& contacts, Random& random);

    /// @param arrangement  in: the start; out: a free arrangement of the same growth, or the last state
    /// @return true: it is free
    bool run(Arrangement& arrangement, const SeparationStyle& style, SearchBudget& budget, int patience);

    /// The items that still overlapped at the end of the last run, without pinned ones.
    const std::vector<std::size_t>& colliding() const { return colliding_; }

  private:
    struct Candidate {
        Vec2 place;
        double loss = 0;
    };

    double loss(std::size_t item, Vec2 place, double enough);
    double order_loss(std::size_t item, Vec2 place);
    double conflict(std::size_t a, std::size_t b) const;
    void update_conflicts();
    void move(std::size_t item);
    void consider(std::size_t item, Vec2 place);
    void propose(std::size_t item);
    Candidate refined(std::size_t item, Candidate start, double step);

    const PackingProblem& problem_;  // outlives this
    Contacts& contacts_;             // outlives this
    Random& random_;                 // outlives this
    PairWeights weights_;
    std::vector<Conflict> conflicts_;
    double total_ = 0;  // sum of the conflicts
    std::vector<std::size_t> colliding_;
    std::vector<bool> has_moved_;  // items that moved since the conflicts were last computed
    std::vector<Box> ranges_;
    PlaceLanes places_;
    std::optional<ReadingOrder> order_;
    std::vector<Candidate> best_, starts_;    // candidates for one move, the best first
    const SeparationStyle* style_ = nullptr;  // during run()
    SearchBudget* budget_ = nullptr;          // during run()
};

}  // namespace vitrine::player
