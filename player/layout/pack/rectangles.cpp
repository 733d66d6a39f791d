#include "player/layout/pack/rectangles.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::size_t cells_a_side = 48;  // of the grid of cuts
constexpr double usual_share = 0.7;       // of the field that regions cover, for their fair sizes
constexpr double uneven_weight = 0.05;    // factor of the mean square of ln(scale) relative to the fair one
constexpr double tiny_weight = 20;        // factor of the mean square of ln(scale) missing to that

using Set = std::uint32_t;  // a bit for each item

/// A cut through the rectangle of some items.
struct Cut {
    Set first = 0;  // the items left of it or above
    bool is_upright = false;
    std::size_t cells = 0;  // width or height of the first part
    float cost = 0;
};

/// A place along one axis at which a region lies inside and a frame covers as much as it can.
/// @param part, room  the rectangle, and its part that regions may use
double place_along(std::array<double, 2> part, std::array<double, 2> room, std::array<double, 2> frame,
                   std::array<double, 2> region) {
    double low = part[1] - frame[1];
    double high = part[0] - frame[0];
    if (low > high) std::swap(low, high);  // the frame is shorter than the rectangle and stays inside it
    const double least = room[0] - region[0];
    const double most = room[1] - region[1];
    return std::clamp((std::max(low, least) + std::min(high, most)) / 2, std::min(least, most), most);
}

/// Finds the best cuts by dynamic programming over sets of items and sizes of rectangles.
class Division {
  public:
    Division(const PackingProblem& problem, const FillingTargets& targets)
        : problem_(problem),
          targets_(targets),
          cell_{problem.whole().width() / cells_a_side, problem.whole().height() / cells_a_side},
          all_((Set{1} << problem.size()) - 1),
          costs_(std::size_t{all_} + 1) {
        set_fair_scales();
        for (Set set = 1; set <= all_; ++set)
            if (set != all_ || problem.size() == 1) fill_table(set);
    }

    /// The best divisions with different first cuts, the best first.
    std::vector<Cut> first_cuts() const {
        std::vector<Cut> cuts;
        for (Set first = (all_ - 1) & all_; first > 0; first = (first - 1) & all_)
            if (is_chosen(all_, first))
                for (const bool is_upright : {false, true})
                    cuts.push_back(best_cut(all_, first, {cells_a_side, cells_a_side}, is_upright));
        std::ranges::sort(cuts, {}, &Cut::cost);
        return cuts;
    }

    /// @param turned  a bit for each cut; its parts are exchanged
    SizedArrangement arrangement(const Cut& first, Set turned) const {
        SizedArrangement made{std::vector<Vec2>(problem_.size()), std::vector<double>(problem_.size())};
        std::size_t cut = 0;
        const auto place = [&](auto& self, Set set, Part part, const Cut* known) -> void {
            if ((set & (set - 1)) == 0) return put_in(made, set, part);
            const Cut here = known != nullptr ? *known : best_cut(set, part.size);
            const bool is_turned = (turned >> cut++ & 1) != 0;
            const std::size_t axis = here.is_upright ? 0 : 1;
            Part one = part;
            Part other = part;
            one.size.at(axis) = here.cells;
            other.size.at(axis) -= here.cells;
            (is_turned ? one : other).corner.at(axis) += (is_turned ? other : one).size.at(axis);
            self(self, here.first, one, nullptr);
            self(self, set & ~here.first, other, nullptr);
        };
        place(place, all_, {{0, 0}, {cells_a_side, cells_a_side}}, &first);
        return made;
    }

    std::size_t cut_count() const { return problem_.size() - 1; }

  private:
    using Cells = std::array<std::size_t, 2>;  // width and height

    struct Part {
        Cells corner;
        Cells size;
    };

    /// True for the half that holds the lowest item of a set: each division into halves is tried once.
    static bool is_chosen(Set set, Set first) { return (first & set & (~set + 1)) != 0; }

    static std::size_t index(Cells size) { return (size[1] - 1) * cells_a_side + size[0] - 1; }

    static std::size_t item_of(Set set) { return static_cast<std::size_t>(std::countr_zero(set)); }

    void set_fair_scales() {
        double sum = 0;
        for (std::size_t i = 0; i < problem_.size(); ++i)
            sum += problem_.shapes[i].area * targets_.natural[i] * targets_.natural[i];
        const double growth = std::sqrt(usual_share * problem_.field.area() / sum);
        for (std::size_t i = 0; i < problem_.size(); ++i)
            fair_.push_back(std::min(targets_.natural[i] * growth, problem_.limits[i]));
    }

    void fill_table(Set set) {
        std::vector<float>& costs = costs_[set];
        costs.assign(cells_a_side * cells_a_side, std::numeric_limits<float>::infinity());
        for (std::size_t height = 1; height <= cells_a_side; ++height)
            for (std::size_t width = 1; width <= cells_a_side; ++width) {
                const Cells size{width, height};
                costs[index(size)] =
                    (set & (set - 1)) == 0 ? cost_alone(item_of(set), size) : best_cut(set, size).cost;
            }
    }

    Cut best_cut(Set set, Cells size) const {
        Cut best{.cost = std::numeric_limits<float>::infinity()};
        for (Set first = (set - 1) & set; first > 0; first = (first - 1) & set) {
            if (!is_chosen(set, first)) continue;
            for (const bool is_upright : {false, true})
                if (const Cut cut = best_cut(set, first, size, is_upright); cut.cost < best.cost) best = cut;
        }
        return best;
    }

    Cut best_cut(Set set, Set first, Cells size, bool is_upright) const {
        Cut best{first, is_upright, 1, std::numeric_limits<float>::infinity()};
        const std::size_t axis = is_upright ? 0 : 1;
        const std::size_t step = is_upright ? 1 : cells_a_side;
        Cells least = size;
        least.at(axis) = 1;
        const float* const one = costs_[first].data() + index(least);
        const float* const other = costs_[set & ~first].data() + index(least);
        for (std::size_t cells = 1; cells < size.at(axis); ++cells) {
            const float cost = one[(cells - 1) * step] + other[(size.at(axis) - cells - 1) * step];
            if (cost < best.cost) best.cost = cost, best.cells = cells;
        }
        return best;
    }

    /// The rectangle of some cells, canvas px.
    Box box_of(const Part& part) const {
        const Vec2 low = problem_.whole().min + Vec2{cell_.x * static_cast<double>(part.corner[0]),
                                                     cell_.y * static_cast<double>(part.corner[1])};
        return {low, low + Vec2{cell_.x * static_cast<double>(part.size[0]),
                                cell_.y * static_cast<double>(part.size[1])}};
    }

    /// The largest scale of an item in a rectangle; not above 0: it does not fit.
    double scale_in(std::size_t item, const Box& box) const {
        const Box& extent = problem_.shapes[item].extent;
        const double room = std::max(problem_.clearance, 2 * (problem_.field.min.x - problem_.whole().min.x));
        return std::min({problem_.limits[item], (box.width() - room) / extent.width(),
                         (box.height() - room) / extent.height()});
    }

    float cost_alone(std::size_t item, Cells size) const {
        const Box box = box_of({{0, 0}, size});
        const double scale = scale_in(item, box);
        if (scale <= 0) return std::numeric_limits<float>::infinity();
        const Box& frame = targets_.frames[item];
        const double filled =
            std::min(box.width(), frame.width() * scale) * std::min(box.height(), frame.height() * scale);
        const double seen = problem_.shapes[item].area * scale * scale;
        const double resized = std::log(scale / fair_[item]);
        const double lack = std::max(0.0, targets_.fair_size - resized);
        const double uneven = uneven_weight * resized * resized + tiny_weight * lack * lack;
        return static_cast<float>((targets_.emptiness * (box.area() - filled) - seen) /
                                      problem_.field.area() +
                                  uneven / static_cast<double>(problem_.size()));
    }

    void put_in(SizedArrangement& made, Set set, const Part& part) const {
        const std::size_t item = item_of(set);
        const Box box = box_of(part);
        const Vec2 half{problem_.clearance / 2, problem_.clearance / 2};
        const Box inner = intersection({box.min + half, box.max - half}, problem_.field);
        const double scale = scale_in(item, box);
        const Box& frame = targets_.frames[item];
        const Box& extent = problem_.shapes[item].extent;
        made.scales[item] = scale;
        made.places[item] = {place_along({box.min.x, box.max.x}, {inner.min.x, inner.max.x},
                                         {frame.min.x * scale, frame.max.x * scale},
                                         {extent.min.x * scale, extent.max.x * scale}),
                             place_along({box.min.y, box.max.y}, {inner.min.y, inner.max.y},
                                         {frame.min.y * scale, frame.max.y * scale},
                                         {extent.min.y * scale, extent.max.y * scale})};
    }

    const PackingProblem& problem_;  // outlives this
    const FillingTargets& targets_;  // outlives this
    Vec2 cell_;                      // canvas px
    Set all_;
    std::vector<double> fair_;               // scales
    std::vector<std::vector<float>> costs_;  // of each set, by the size of its rectangle
};

/// The divisions with one first cut, the parts of each cut exchanged or not; the best one first.
std::vector<SizedArrangement> turned_divisions(const PackingProblem& problem, const FillingTargets& targets,
                                               const Division& division, const Cut& first) {
    using Costed = std::pair<double, SizedArrangement>;
    PackingProblem sized = problem;
    std::vector<Costed> made;
    for (Set turned = 0; turned < Set{1} << division.cut_count(); ++turned) {
        SizedArrangement one = division.arrangement(first, turned);
        sized.scales = one.scales;
        const double cost = targets.emptiness * exact_unfilled_share(sized, targets.frames, {one.places, 1}) +
                            way_weight * mean_way(problem, targets, one.places);
        made.emplace_back(cost, std::move(one));
    }
    std::ranges::stable_sort(made, {}, &Costed::first);
    std::vector<SizedArrangement> sorted;
    sorted.reserve(made.size());
    for (Costed& one : made)
        sorted.push_back(std::move(one.second));
    return sorted;
}

}  // namespace

std::vector<SizedArrangement> best_rectangles(const PackingProblem& problem, const FillingTargets& targets,
                                              std::size_t count) {
    assert(problem.size() >= 2 && problem.size() <= max_in_rectangles);
    const Division division(problem, targets);
    std::vector<std::vector<SizedArrangement>> turned;
    for (const Cut& cut : division.first_cuts()) {
        if (turned.size() == count || !std::isfinite(cut.cost)) break;
        turned.push_back(turned_divisions(problem, targets, division, cut));
    }
    std::vector<SizedArrangement> results;
    const std::size_t turns = std::size_t{1} << division.cut_count();
    for (std::size_t k = 0; k < turns; ++k)
        for (std::vector<SizedArrangement>& of_cut : turned)
            if (results.size() < count) results.push_back(std::move(of_cut[k]));
    return results;
}

}  // namespace vitrine::player
