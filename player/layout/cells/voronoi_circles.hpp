#pragma once

#include "player/layout/cells/voronoi_numbers.hpp"

#include <boost/polygon/detail/voronoi_predicates.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::player {

// boost computes the circle that touches three sites in double numbers. If the error may exceed 64 units in
// the last place, it computes the circle again with exact numbers. Canvas coordinates are many times as large
// as the distances between sites, so this happens for most circles and takes most of the diagram's time. Here
// the circles are computed relative to a corner near the sites, with rounding, and a bound of their error is
// computed. Exact numbers are used only if the error is too large, that is, if the sites hardly determine the
// circle.

/// The coordinates of sites relative to a nearby corner.
template <typename Site, typename Circle> class NearbyCorner {
  public:
    /// The corner is left of and above the sites by their own extent, because results near 0 are never exact.
    NearbyCorner(const Site& a, const Site& b, const Site& c) {
        const auto [left, right] = std::minmax({a.x0(), a.x1(), b.x0(), b.x1(), c.x0(), c.x1()});
        const auto [top, bottom] = std::minmax({a.y0(), a.y1(), b.y0(), b.y1(), c.y0(), c.y1()});
        extent_ = std::max(right - left, bottom - top);
        x_ = left - extent_;
        y_ = top - extent_;
    }

    double extent() const { return extent_; }

    Site moved(const Site& site) const {
        if (!site.is_inverse()) return {site.x0() - x_, site.y0() - y_, site.x1() - x_, site.y1() - y_};
        return Site(site.x1() - x_, site.y1() - y_, site.x0() - x_, site.y0() - y_).inverse();
    }

    void move_back(Circle& circle) const {
        circle.x(circle.x() + x_);
        circle.y(circle.y() + y_);
        circle.lower_x(circle.lower_x() + x_);
    }

  private:
    typename Site::coordinate_type x_ = 0, y_ = 0, extent_ = 0;
};

/// Checks a computed circle against the three sites that it shall touch. Holds the linearised conditions for
/// its centre and radius, and the errors of these conditions.
class CircleCheck {
  public:
    CircleCheck(double x, double y, double radius) : x_(x), y_(y), radius_(radius) {}

    /// Condition: the circle touches a point.
    void add_point(double x, double y) {
        const double dx = x_ - x;
        const double dy = y_ - y;
        const double distance = std::sqrt(dx * dx + dy * dy);
        add({dx / distance, dy / distance, -1}, distance - radius_);
    }

    /// Condition: the circle touches the line through two points.
    void add_line(double x0, double y0, double x1, double y1) {
        const double dx = x1 - x0;
        const double dy = y1 - y0;
        const double size = std::sqrt(dx * dx + dy * dy);
        const double side = (dx * (y_ - y0) - dy * (x_ - x0)) / size;
        const double sign = side < 0 ? -1 : 1;
        add({-sign * dy / size, sign * dx / size, -1}, std::abs(side) - radius_);
    }

    /// Condition: the circle touches the line through two points at the first of them.
    void add_foot(double x0, double y0, double x1, double y1) {
        const double dx = x1 - x0;
        const double dy = y1 - y0;
        const double size = std::sqrt(dx * dx + dy * dy);
        add({dx / size, dy / size, 0}, (dx * (x_ - x0) + dy * (y_ - y0)) / size);
    }

    /// True if centre and radius are exact to `tolerance`, all in the sites' units. @pre three conditions
    bool holds(double tolerance) const {
        const auto& [a, b, c] = rows_;
        const double determinant = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                                   a[2] * (b[0] * c[1] - b[1] * c[0]);
        constexpr double max_cofactors = 8;  // bound of the sum of three cofactors; each entry is at most 1
        return max_cofactors * missed_ <= tolerance * std::abs(determinant);  // false if a value is NaN
    }

  private:
    void add(const std::array<double, 3>& row, double missed_by) {
        rows_[count_++] = row;
        missed_ = std::max(missed_, std::abs(missed_by));
        if (std::isnan(missed_by)) missed_ = missed_by;
    }

    double x_, y_, radius_;
    std::array<std::array<double, 3>, 3> rows_{};
    std::size_t count_ = 0;
    double missed_ = 0;
};

/// Computes the circles of three sites relative to a nearby corner, with rounding; exactly if the error is
/// too large.
template <typename Site, typename Circle, typename Rounding, typename Exact> class CheckedCircles {
  public:
    void ppp(const Site& a, const Site& b, const Site& c, Circle& circle) {
        find(a, b, c, circle,
             [&](auto& way, const Site& p, const Site& q, const Site& r) { way.ppp(p, q, r, circle); });
    }

    void pps(const Site& a, const Site& b, const Site& c, int segment, Circle& circle) {
        find(a, b, c, circle, [&](auto& way, const Site& p, const Site& q, const Site& r) {
            way.pps(p, q, r, segment, circle);
        });
    }

    void pss(const Site& a, const Site& b, const Site& c, int point, Circle& circle) {
        find(a, b, c, circle, [&](auto& way, const Site& p, const Site& q, const Site& r) {
            way.pss(p, q, r, point, circle);
        });
    }

    void sss(const Site& a, const Site& b, const Site& c, Circle& circle) {
        find(a, b, c, circle,
             [&](auto& way, const Site& p, const Site& q, const Site& r) { way.sss(p, q, r, circle); });
    }

  private:
    /// In the sites' units. For boost two events are equal if they differ by less than 2^-47 of their
    /// coordinates, and these are at least 2^24.
    static constexpr double tolerance = 0x1p-26;

    template <typename Find>
    void find(const Site& a, const Site& b, const Site& c, Circle& circle, const Find& find_by) {
        const NearbyCorner<Site, Circle> corner(a, b, c);
        const std::array<Site, 3> sites{corner.moved(a), corner.moved(b), corner.moved(c)};
        find_by(rounding_, sites[0], sites[1], sites[2]);
        if (!is_good(sites, circle)) find_by(exact_, sites[0], sites[1], sites[2]);
        corner.move_back(circle);
    }

    static bool is_good(const std::array<Site, 3>& sites, const Circle& circle) {
        CircleCheck check(circle.x(), circle.y(), circle.lower_x() - circle.x());
        for (const Site& site : sites) {
            if (site.is_segment()) {
                check.add_line(site.x0(), site.y0(), site.x1(), site.y1());
                continue;
            }
            const Site* own = nullptr;  // the segment of which the point is an end
            bool is_start = false;
            for (const Site& other : sites) {
                if (!other.is_segment()) continue;
                if (other.point0() == site.point0()) own = &other, is_start = true;
                if (other.point1() == site.point0()) own = &other, is_start = false;
            }
            if (own == nullptr)
                check.add_point(site.x(), site.y());
            else if (is_start)
                check.add_foot(own->x0(), own->y0(), own->x1(), own->y1());
            else
                check.add_foot(own->x1(), own->y1(), own->x0(), own->y0());
        }
        return check.holds(tolerance);
    }

    Rounding rounding_;
    Exact exact_;
};

/// The diagram's predicates with circles from CheckedCircles.
struct VoronoiPredicates : boost::polygon::detail::voronoi_predicates<VoronoiNumbers> {
    using Rounding = boost::polygon::detail::voronoi_predicates<RoundingNumbers>;

    template <typename Site, typename Circle>
    using circle_formation_predicate = voronoi_predicates::circle_formation_predicate<
        Site, Circle, circle_existence_predicate<Site>,
        CheckedCircles<Site, Circle, Rounding::lazy_circle_formation_functor<Site, Circle>,
                       lazy_circle_formation_functor<Site, Circle>>>;
};

}  // namespace vitrine::player
