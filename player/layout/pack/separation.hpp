#pragma once

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/search_budget.hpp"
#include "player/layout/pack/reading_order.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace vitrine::player {

/// How items may move while they are separated.
struct SeparationStyle {
    bool roams = true;          // tries places all over the field, not only near
    std::vector<Vec2> homes;    // canvas px, where items would like to stay; empty: nowhere
    double pull = 0;            // loss per px from home, against px of depth
    double finest_step = 0.02;  // canvas px, of the last refinement
};

/// Uniform in a box.
Vec2 random_place(const Box& range, Random& random);

/// Pulls overlapping items apart at one growth: guided local search.
///
/// The loss is the sum over all pairs of weight times depth. A colliding item moves to the best of some
/// places tried all over its range, some near it and those that clear it of one neighbour, the best refined
/// along the axes. Where the order counts, so does the way to it. After each round the weights of pairs that
/// still collide rise and the others decay, which lifts the search out of local minima. Source: ALGORITHMS
/// (d) "Escaping minima"; the idea is that of sparrow (arXiv 2509.13329, algorithms 9 and 11). Differs: the
/// exact penetration depth of convex shapes instead of a proxy by circles.
class Separation {
  public:
    /// Both are borrowed and must outlive the object.
    Separation(const Ground& ground, Contacts& contacts, Random& random);

    /// @param arrangement  in: where to begin; out: a free arrangement of the same growth, or where it ended
    /// @return whether it is free
    bool run(Arrangement& arrangement, const SeparationStyle& style, Effort& effort, int patience);

    /// The items that the last run left in each other's way, pinned ones excepted.
    const std::vector<std::size_t>& colliding() const { return colliding_; }

  private:
    struct Candidate {
        Vec2 place;
        double loss = 0;
    };

    struct Conflict {
        std::size_t a = 0, b = 0;  // a > b
        double size = 0;           // canvas px that keep the pair from being free, > 0
    };

    std::span<float> weights(std::size_t item) {
        return {weights_.data() + item * ground_.size(), ground_.size()};
    }

    double loss(std::size_t item, Vec2 place, double enough);
    double order_loss(std::size_t item, Vec2 place);
    double conflict(std::size_t a, std::size_t b) const;
    void update_conflicts();
    void move(std::size_t item);
    void consider(std::size_t item, Vec2 place);
    void propose(std::size_t item);
    Candidate refined(std::size_t item, Candidate start, double step);
    void reweigh();

    const Ground& ground_;                                     // outlives this
    Contacts& contacts_;                                       // outlives this
    Random& random_;                                           // outlives this
    std::vector<float> weights_;                               // of [a * size + b] and [b * size + a]
    std::vector<std::pair<std::size_t, std::size_t>> raised_;  // weights above 1
    std::vector<Conflict> conflicts_;
    double total_ = 0;  // of the conflicts
    std::vector<std::size_t> colliding_;
    std::vector<bool> has_moved_;  // since the conflicts were found
    std::vector<Box> ranges_;
    Spots spots_;
    std::optional<ReadingOrder> order_;
    std::vector<Candidate> best_, starts_;    // of one move, the best first
    const SeparationStyle* style_ = nullptr;  // during run()
    Effort* effort_ = nullptr;                // during run()
};

}  // namespace vitrine::player
