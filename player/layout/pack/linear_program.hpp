#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::player {

/// Maximises one of some unknowns without sign, under constraints that all hold where every unknown is 0:
/// room + sum of slopes * unknowns >= 0, room >= 0. Dense, for some hundred rows.
///
/// The simplex method on the dictionary: each row's room is a basic unknown at first; an unknown without sign
/// that has entered never leaves. As the start is feasible there is only the second phase.
class LinearProgram {
  public:
    explicit LinearProgram(std::size_t unknowns);

    /// All slopes are 0 until set. @return the row
    std::span<double> add_row(double room);

    /// @return the unknowns where `objective` is largest, or where `most_pivots` ended; feasible in any case
    std::vector<double> maximise(std::size_t objective, int most_pivots);

    int pivots() const { return pivots_; }

    std::size_t rows() const { return rooms_.size(); }

  private:
    double* row(std::size_t r) { return table_.data() + r * width_; }

    std::size_t entering() const;
    std::size_t leaving(std::size_t column);
    void pivot(std::size_t r, std::size_t column);

    std::size_t unknowns_;
    std::size_t width_;          // unknowns, rounded up
    std::vector<double> table_;  // rooms_.size() x width_: basic unknown = room + sum of row * nonbasic
    std::vector<double> rooms_;
    std::vector<double> gains_;          // of the objective, per nonbasic unknown
    std::vector<std::size_t> basic_;     // per row: the free unknown that it gives, or `constraint`
    std::vector<std::size_t> nonbasic_;  // per column: the free unknown that it stands for, or `constraint`
    int pivots_ = 0;
};

}  // namespace vitrine::player
