#pragma once

#include "analyzer/tapestry/synthesis/affinity.hpp"

#include <vector>

namespace vitrine::analyzer {

/// A set of frames that stand for all frames, each frame shown by the one that shows it best; what it costs,
/// and what a further or another one would change, is known without going through all frames.
class Medoids {
  public:
    /// @param costs  outlives this
    explicit Medoids(const Affinity& costs);

    bool contains(int frame) const { return is_medoid_[static_cast<std::size_t>(frame)]; }

    const std::vector<int>& sorted() const { return sorted_; }

    /// The sum over all frames of A_ij of the medoid that shows it best, `far` where none is near.
    /// Source: Video Tapestries 4.1, n times eq. 4, whose second term is 0.
    double cost() const;

    /// The amount by which the cost falls where a frame that is no medoid becomes one.
    double gain(int frame) const;

    /// The same where `before` has become one already.
    double gain_after(int frame, int before) const;

    void add(int frame);

    /// Computes the change of the cost where `in` takes the place of each medoid of [from, to), in that
    /// order; the values for other frames of that range mean nothing.
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
    std::vector<Service> services_;  // a frame
    std::vector<double> loss_;       // a medoid: what its loss alone would cost
};

}  // namespace vitrine::analyzer
