#include "player/layout/pack/linear_program.hpp"

#include <cmath>
#include <limits>

namespace vitrine::player {

namespace {

constexpr std::size_t constraint = std::numeric_limits<std::size_t>::max();
constexpr std::size_t none = constraint;
constexpr double min_gain = 1e-10;
constexpr double min_slope = 1e-9;

}  // namespace

LinearProgram::LinearProgram(std::size_t unknowns)
    : unknowns_(unknowns), width_((unknowns + 1) / 2 * 2), gains_(width_, 0), nonbasic_(unknowns) {
    for (std::size_t k = 0; k < unknowns; ++k)
        nonbasic_[k] = k;
}

std::span<double> LinearProgram::add_row(double room) {
    rooms_.push_back(room);
    basic_.push_back(constraint);
    table_.resize(table_.size() + width_, 0);
    return {row(rooms_.size() - 1), unknowns_};
}

/// The column whose unknown raises the objective fastest. An unknown without sign may also fall.
std::size_t LinearProgram::entering() const {
    std::size_t best = none;
    double largest = min_gain;
    for (std::size_t k = 0; k < unknowns_; ++k) {
        const double gain = nonbasic_[k] == constraint ? gains_[k] : std::abs(gains_[k]);
        if (gain <= largest) continue;
        largest = gain;
        best = k;
    }
    return best;
}

/// The constraint that stops this column's unknown first.
std::size_t LinearProgram::leaving(std::size_t column) {
    const double turn = gains_[column] > 0 ? 1 : -1;
    std::size_t best = none;
    double smallest = std::numeric_limits<double>::infinity();
    double steepest = 0;
    for (std::size_t r = 0; r < rooms_.size(); ++r) {
        const double fall = -turn * row(r)[column];
        if (basic_[r] != constraint || fall <= min_slope) continue;
        const double until = rooms_[r] / fall;
        if (until > smallest || (until == smallest && fall <= steepest)) continue;
        smallest = until;
        steepest = fall;
        best = r;
    }
    return best;
}

/// Exchanges a row's basic unknown with a column's unknown.
void LinearProgram::pivot(std::size_t r, std::size_t column) {
    double* const from = row(r);
    const double inverse = 1 / from[column];
    for (std::size_t k = 0; k < width_; ++k)
        from[k] *= -inverse;
    from[column] = inverse;
    rooms_[r] *= -inverse;
    const auto substitute = [&](double* to, double& room) {
        const double factor = to[column];
        if (factor == 0) return;
        to[column] = 0;
        for (std::size_t k = 0; k < width_; ++k)
            to[k] += factor * from[k];
        room += factor * rooms_[r];
    };
    double objective = 0;
    for (std::size_t other = 0; other < rooms_.size(); ++other) {
        if (other == r) continue;
        substitute(row(other), rooms_[other]);
        if (basic_[other] == constraint && rooms_[other] < 0) rooms_[other] = 0;  // rounding
    }
    substitute(gains_.data(), objective);
    std::swap(basic_[r], nonbasic_[column]);
    ++pivots_;
}

std::vector<double> LinearProgram::maximise(std::size_t objective, int max_pivots) {
    gains_[objective] = 1;
    while (pivots_ < max_pivots) {
        const std::size_t column = entering();
        if (column == none) break;
        const std::size_t r = leaving(column);
        if (r == none) break;
        pivot(r, column);
    }
    std::vector<double> values(unknowns_, 0);
    for (std::size_t r = 0; r < rooms_.size(); ++r)
        if (basic_[r] != constraint) values[basic_[r]] = rooms_[r];
    return values;
}

}  // namespace vitrine::player
