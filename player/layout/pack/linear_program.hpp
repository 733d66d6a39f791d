#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::player {

/// Maximises one of several unknowns that may be negative, under constraints that all hold where every
/// unknown is 0: room + sum of slopes * unknowns >= 0, room >= 0. Dense, for some hundred rows.
///
/// The simplex method on the dictionary: each row's room is a basic unknown at first; an unknown that may be
/// negative never leaves once it has entered. The start is feasible, so there is only the second phase.
class LinearProgram {
  public:
    explicit LinearProgram(std::size_t unknowns);

    /// Adds a constraint whose slopes are 0 until set. @return its slopes
    std::span<double> add_row(double room);

    /// @return the unknowns where `objective` is largest, or after `max_pivots`; feasible in any case
    std::vector<double> maximise(std::size_t objective, int max_pivots);

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
    std::vector<double> gains_;          // slopes of the objective, one a nonbasic unknown
    std::vector<std::size_t> basic_;     // one a row: the free unknown that it gives, or `constraint`
    std::vector<std::size_t> nonbasic_;  // one a column: the free unknown that it stands for, or `constraint`
    int pivots_ = 0;
};

}  // namespace vitrine::player
