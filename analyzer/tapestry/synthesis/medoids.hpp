#pragma once

#include "analyzer/tapestry/synthesis/affinity.hpp"

#include <vector>

namespace vitrine::analyzer {

/// A set of frames, the medoids, that stand for all frames: each frame is shown by the medoid that shows it
/// best. The cost of the set, and its change by a further or another medoid, are known without a pass over
/// all frames.
class Medoids {
  public:
    /// @param costs  outlives this
    explicit Medoids(const Affinity& costs);

    bool contains(int frame) const { return is_medoid_[static_cast<std::size_t>(frame)]; }

    const std::vector<int>& sorted() const { return sorted_; }

    /// The sum over all frames i of A_ij, with j the medoid that shows i best; `far` where none is near.
    /// Source: Video Tapestries 4.1, n times eq. 4, whose second term is 0.
    double cost() const;

    /// The amount by which the cost falls if a frame that is no medoid becomes one.
    double gain(int frame) const;

    /// The same if `before` has become a medoid already.
    double gain_after(int frame, int before) const;

    void add(int frame);

    /// Computes the change of the cost if `in` takes the place of each medoid of [from, to), in that order.
    /// The values for other frames of that range mean nothing.
    void swap_changes(int in, int from, int to, std::vector<double>& changes) const;

    void swap(int out, int in);

  private:
    struct Service {
        float cost = 0;    // cost of the medoid that shows the frame best
        float second = 0;  // cost of the next best medoid
        int by = -1;       // -1: none is near
        int second_by = -1;
    };

    void offer(Service& service, int medoid, float cost) const;
    void serve_anew(int frame);

    const Affinity& costs_;
    std::vector<bool> is_medoid_;
    std::vector<int> sorted_;
    std::vector<Service> services_;  // one a frame
    std::vector<double> loss_;       // one a frame: for a medoid, the cost of losing it alone
};

}  // namespace vitrine::analyzer
