#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::player {

/// Maximises one of several unknowns, which may be negative. The constraints are room + sum of slopes *
/// unknowns >= 0, with room >= 0: they all hold if every unknown is 0. Dense, for some hundred rows.
///
/// The simplex method on the dictionary: at the start each row's room is a basic unknown. An unknown that may
/// be negative never leaves once it has entered. The start is feasible, so only the second phase is needed.
class LinearProgram {
  public:
    explicit LinearProgram(std::size_t unknowns);

    /// Adds a constraint with slopes 0. @return its slopes, to be set
    std::span<double> add_row(double room);

    /// @return the unknowns with the largest `objective`, or those after `max_pivots`; always feasible
    std::vector<double> maximise(std::size_t objective, int max_pivots);

    int pivots() const { return pivots_; }

    std::size_t rows() const { return rooms_.size(); }

  private:
    double* row(std::size_t r) { return table_.data() + r * width_; }

    std::size_t entering() const;
    std::size_t leaving(std::size_t column);
    void pivot(std::size_t r, std::size_t column);

    std::size_t unknowns_;
    std::size_t width_;          // number of unknowns, rounded up
    std::vector<double> table_;  // rooms_.size() x width_: basic unknown = room + sum of row * nonbasic
    std::vector<double> rooms_;
    std::vector<double> gains_;          // slopes of the objective, one for each nonbasic unknown
    std::vector<std::size_t> basic_;     // one for each row: its free unknown, or `constraint`
    std::vector<std::size_t> nonbasic_;  // one for each column: its free unknown, or `constraint`
    int pivots_ = 0;
};

}  // namespace vitrine::player
