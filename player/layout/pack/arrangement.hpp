#pragma once

#include "player/layout/pack/contacts.hpp"
#include "player/layout/pack/reading_order.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// The input of a packing: the shapes, their wished scales, the canvas.
struct PackingProblem {
    std::vector<Shape> shapes;
    std::vector<double> scales;  // wished canvas px per source px, relative: all are multiplied by one growth
    std::vector<double> limits;  // no item beyond this scale: blur, or it would not fit on the canvas
    std::vector<bool> pinned;    // keeps its place and its scale, which is scales[i] whatever the growth
    std::vector<Vec2> pinned_places;  // canvas px, centroids; of pinned items only
    Box field;                        // canvas px, where I-Regions may be
    double clearance = 0;             // canvas px between I-Regions
    bool keeps_order = false;         // the items are read in their order

    std::size_t size() const { return shapes.size(); }

    /// The scale of an item at a growth: scales * growth, up to the limit.
    double scale(std::size_t item, double growth) const;

    /// The same as a function of the growth.
    GrowingScale growing_scale(std::size_t item) const;

    /// The box of places at which an item's region lies in the field. A pinned item: anywhere.
    Box place_range(std::size_t item, double growth) const;
};

/// The places of all items: centroids in canvas px.
struct Arrangement {
    std::vector<Vec2> places;
    double growth = 1;
};

/// The lines in which the items are read at a growth.
ReadingOrder reading_order(const PackingProblem& problem, double growth);

/// The point of a box that is nearest to a place.
Vec2 moved_into(Vec2 place, const Box& range);

/// True where all items keep clear of each other and inside the field, and the order where it counts. Sets
/// the scales of `contacts`.
bool is_free(const PackingProblem& problem, const Arrangement& arrangement, Contacts& contacts);

/// True where no two I-Regions share inner points, on the grid of exact areas; pinned items
/// among themselves excepted.
bool is_exactly_free(const PackingProblem& problem, const Arrangement& arrangement);

/// True where an item may stand at a place, if the others stay. @pre the scales of `contacts` are those of
/// the arrangement
bool is_allowed_place(const PackingProblem& problem, const Contacts& contacts, const Arrangement& arrangement,
                      std::size_t item, Vec2 place);

/// True where the order holds wherever it counts.
bool is_in_order(const PackingProblem& problem, const std::vector<Vec2>& places, double growth);

/// The largest growth in [min, max] at which all items are free where they stand; 0 where none is.
double max_free_growth(const PackingProblem& problem, const Arrangement& arrangement,
                       const Contacts& contacts, double min, double max);

/// The largest scale, up to `max`, at which an item is free where it stands if the others stay; 0 where none
/// is. The order does not count.
double max_free_scale(const PackingProblem& problem, const Arrangement& arrangement, const Contacts& contacts,
                      std::size_t item, double max);

/// The growth at which every item is at its limit.
double final_growth(const PackingProblem& problem);

/// The arrangement's scales for Contacts::set_scales.
std::vector<double> scales_at(const PackingProblem& problem, double growth);

/// Area of all I-Regions, canvas px^2.
double region_area(const PackingProblem& problem, double growth);

}  // namespace vitrine::player
