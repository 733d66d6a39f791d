#pragma once

#include "player/layout/arrangement.hpp"
#include "player/layout/effort.hpp"

#include <span>
#include <vector>

namespace vitrine {

/// How items may move while they are separated.
struct SeparationStyle {
    bool roams = true;        // tries places all over the field, not only near
    std::vector<Vec2> homes;  // canvas px, where items would like to stay; empty: nowhere
    double pull = 0;          // loss per px from home, against px of depth
};

/// Pulls overlapping items apart at one growth: guided local search.
///
/// The loss is the sum over all pairs of weight times depth. A colliding item moves to the best of some
/// places tried all over its range, some near it and those that clear it of one neighbour, the best refined
/// along the axes. After each round the weights of pairs that still collide rise and the others decay,
/// which lifts the search out of local minima.
/// Source: ALGORITHMS (d) "Escaping minima"; the idea is that of sparrow (arXiv 2509.13329, algorithms 9 and
/// 11). Differs: the exact penetration depth of convex shapes instead of a proxy by circles.
class Separation {
  public:
    /// Both are borrowed and must outlive the object.
    Separation(const Ground& ground, Contacts& contacts, Random& random);

    /// @param arrangement  in: where to begin; out: a free arrangement of the same growth, or where it ended
    /// @return whether it is free
    bool run(Arrangement& arrangement, const SeparationStyle& style, Effort& effort, int patience);

  private:
    struct Candidate {
        Vec2 place;
        double loss = 0;
    };

    double& weight(std::size_t a, std::size_t b) { return weights_[a * ground_.size() + b]; }

    double loss(std::size_t item, Vec2 place, double enough);
    double all_depths();
    std::vector<std::size_t> colliding();
    void move(std::size_t item);
    void consider(std::size_t item, Vec2 place);
    void propose(std::size_t item);
    Candidate refined(std::size_t item, Candidate start, double step);
    void reweigh();

    const Ground& ground_;  // outlives this
    Contacts& contacts_;    // outlives this
    Random& random_;        // outlives this
    std::vector<double> weights_;
    std::vector<Box> ranges_;
    std::vector<Vec2> places_;
    std::vector<Candidate> best_;             // of one move, the best first
    const SeparationStyle* style_ = nullptr;  // during run()
    Effort* effort_ = nullptr;                // during run()
};

}  // namespace vitrine
